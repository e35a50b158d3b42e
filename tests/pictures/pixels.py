"""Reads PNG files of 8 bits a channel, as browsers and VTK write them; needs Python's standard library alone."""

import collections
import struct
import zlib


def _unfiltered(data, width, height, channels):
    """The rows of a PNG, whose five filters tell a byte by those to the left, above, and above on the left."""
    stride = width * channels
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind = data[y * (stride + 1)]
        row = bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        if kind == 1:
            for i in range(channels, stride):
                row[i] = (row[i] + row[i - channels]) & 255
        elif kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, above))
        elif kind == 3:
            for i in range(stride):
                left = row[i - channels] if i >= channels else 0
                row[i] = (row[i] + (left + above[i]) // 2) & 255
        elif kind == 4:
            for i in range(stride):
                left, corner = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
                by_left, by_above, by_corner = abs(above[i] - corner), abs(left - corner), abs(left + above[i] - 2 * corner)
                best = left if by_left <= by_above and by_left <= by_corner else above[i] if by_above <= by_corner else corner
                row[i] = (row[i] + best) & 255
        rows.append(row)
        above = row
    return rows


class Pixels:
    """A picture; (0, 0) is its upper left corner."""

    def __init__(self, png):
        if png[:8] != b"\x89PNG\r\n\x1a\n":
            raise ValueError("not a PNG")
        at, data = 8, b""
        while at < len(png):
            length, kind = struct.unpack(">I4s", png[at:at + 8])
            body = png[at + 8:at + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
                if depth != 8 or color not in (2, 6) or interlaced:
                    raise ValueError("a PNG of another kind")
                self.channels = 3 if color == 2 else 4
            elif kind == b"IDAT":
                data += body
            at += 12 + length
        self.rows = _unfiltered(zlib.decompress(data), self.width, self.height, self.channels)

    def at(self, x, y):
        return tuple(self.rows[y][x * self.channels:x * self.channels + 3])

    def _colors(self, row):
        return zip(row[0::self.channels], row[1::self.channels], row[2::self.channels])

    def histogram(self, left=0):
        """How many pixels of each colour there are, right of a column."""
        counts = collections.Counter()
        for row in self.rows:
            counts.update(self._colors(row[left * self.channels:]))
        return counts

    def differing(self, other, left=0):
        """The number of pixels right of a column at which two pictures of one size differ by more than one level, which
        is how far a browser's own rounding goes when it draws the same once more."""
        total = 0
        for mine, theirs in zip(self.rows, other.rows):
            if mine != theirs:
                pairs = zip(self._colors(mine[left * self.channels:]), other._colors(theirs[left * other.channels:]))
                total += sum(a != b and max(abs(i - j) for i, j in zip(a, b)) > 1 for a, b in pairs)
        return total
