#!/usr/bin/env python3
"""Compares two pictures of `gnomon image --out FILE.pfm`: docs/compare_pictures.py A.pfm B.pfm

Prints the root of the mean square of what their radiances differ by, and the largest difference, as shares of the largest
radiance of the first.
"""
import array
import sys


def radiances(file):
    with open(file, "rb") as stream:
        kind, size, scale = (stream.readline().strip() for _ in range(3))
        if kind != b"PF" or float(scale) >= 0:
            sys.exit(f"{file}: expected a portable float map of three colours, little endian")
        values = array.array("f", stream.read())
    if sys.byteorder == "big":
        values.byteswap()
    return size, values


def main():
    (size, a), (other, b) = radiances(sys.argv[1]), radiances(sys.argv[2])
    if size != other or len(a) != len(b):
        sys.exit("the pictures are not of one size")
    most = max(a)
    differences = [abs(x - y) for x, y in zip(a, b)]
    rms = (sum(d * d for d in differences) / len(differences)) ** 0.5
    print(f"rms {rms / most:.2g}, largest {max(differences) / most:.2g}")


if __name__ == "__main__":
    main()
