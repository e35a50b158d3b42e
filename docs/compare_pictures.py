#!/usr/bin/env python3
"""Compares two pictures of `gnomon image --out FILE.pfm`: docs/compare_pictures.py A.pfm B.pfm [EXPOSURE]

Prints the root of the mean square of what their radiances differ by, and the largest difference, as shares of the largest
radiance of the first; with an exposure also the median and the root of the mean square of what the pixels' grey levels
differ by in a PNG, and how many of a hundred pixels do by more than one.
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


def level(radiance, exposure):
    """As `gnomon image` has it, not rounded."""
    x = min(radiance * exposure, 1)
    return 255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055)


def tell_levels(a, b, exposure):
    channels = [abs(level(x, exposure) - level(y, exposure)) for x, y in zip(a, b)]
    pixels = sorted(max(channels[k:k + 3]) for k in range(0, len(channels), 3))
    shown = [p for p in pixels if p > 0]  # what the meshes do not touch does not change at all
    rms = (sum(p * p for p in pixels) / len(pixels)) ** 0.5
    more = sum(p > 1 for p in pixels)
    print(f"grey levels: rms {rms:.2g}, median of the pixels that change {shown[len(shown) // 2] if shown else 0:.2g}, "
          f"{100 * more / len(pixels):.2g} % of all by more than one")


def main():
    (size, a), (other, b) = radiances(sys.argv[1]), radiances(sys.argv[2])
    if size != other or len(a) != len(b):
        sys.exit("the pictures are not of one size")
    most = max(a)
    differences = [abs(x - y) for x, y in zip(a, b)]
    rms = (sum(d * d for d in differences) / len(differences)) ** 0.5
    print(f"rms {rms / most:.2g}, largest {max(differences) / most:.2g}")
    if len(sys.argv) > 3:
        tell_levels(a, b, float(sys.argv[3]))


if __name__ == "__main__":
    main()
