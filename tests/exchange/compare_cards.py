#!/usr/bin/python3
"""Compares hair cards with the strands that they stand for, seen from four sides without light.

    compare_cards.py STRANDS.hair CARDS.glb [PICTURE.ppm [LEVEL]]

Both are drawn by a small rasteriser of this script's own, without perspective: strands by the area that they cover, cards
with their alpha cut off as the material says. Prints, as one line of JSON, by side: the overlap of the silhouettes
(intersection over union, where at least half of a pixel is covered), and the mean colours (sRGB) and how far they are
apart, as a part of the strands' own; and the part of the atlas that cards show. The picture shows both, one above the
other. LEVEL is one of those of detail, of which 0 is the first.
"""
import json
import struct
import subprocess
import sys

import numpy as np

PIXELS = 192  # A side of the compared pictures;
FINER = 3  # each pixel is the mean of so many drawn ones, squared.
MOST_STRANDS = 20000  # Fewer that are as much wider cover as much.
# Degrees from the face toward the head's left; without perspective the silhouettes of the other sides mirror these.
SIDES = {"front": 0, "front left": 45, "left": 90, "back left": 135}


def read_strands(path):
    """Points per strand, positions, diameters and colours, as the `.hair` format has them."""
    data = open(path, "rb").read()
    strands, points = struct.unpack_from("<II", data, 4)
    counts = np.frombuffer(data, "<u2", strands, 128).astype(int) + 1
    at = 128 + 2 * strands
    positions = np.frombuffer(data, "<f4", 3 * points, at).reshape(-1, 3)
    widths = np.frombuffer(data, "<f4", points, at + 12 * points)
    colours = np.frombuffer(data, "<f4", 3 * points, at + 20 * points).reshape(-1, 3)
    thinner = max(1, strands // MOST_STRANDS)
    chosen = np.repeat(np.arange(strands) % thinner == 0, counts)
    return (counts[::thinner], positions[chosen].astype(float), thinner * widths[chosen].astype(float),
            colours[chosen].astype(float))


class Cards:
    """Triangles of a level of a glTF of cards: corners, uvs, and the base colour's texels."""

    def __init__(self, path, level):
        data = open(path, "rb").read()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.bin = data[28 + length:]
        corners, uvs = [], []
        for mesh in self.json["meshes"]:
            name, _, number = mesh["name"].rpartition("_LOD")
            if name and int(number) != level:
                continue
            for part in mesh["primitives"]:
                if "alphaCutoff" not in self.json["materials"][part["material"]]:
                    continue
                order = self.values(part["indices"], "<u4", 1).reshape(-1, 3)
                corners.append(self.values(part["attributes"]["POSITION"], "<f4", 3)[order])
                uvs.append(self.values(part["attributes"]["TEXCOORD_0"], "<f4", 2)[order])
        self.corners = np.concatenate(corners).astype(float)
        self.uvs = np.concatenate(uvs).astype(float)
        material = self.json["materials"][0]
        self.cutoff = material["alphaCutoff"]
        texture = material["pbrMetallicRoughness"]["baseColorTexture"]["index"]
        view = self.view(self.json["images"][self.json["textures"][texture]["source"]]["bufferView"])
        raw = subprocess.run(["convert", "png:-", "-depth", "8", "rgba:-"], input=view, capture_output=True, check=True)
        size = int(round((len(raw.stdout) / 4) ** 0.5))
        self.texels = np.frombuffer(raw.stdout, np.uint8).reshape(size, size, 4) / 255.0

    def view(self, index):
        view = self.json["bufferViews"][index]
        return self.bin[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]

    def values(self, index, kind, width):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        start = view["byteOffset"] + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", 4 * width)
        return np.ndarray((accessor["count"], width), kind, self.bin, start, (stride, 4))


def projected(positions, side, centre, scale):
    turn = np.radians(SIDES[side])
    moved = positions - centre
    x = (moved[..., 0] * np.cos(turn) - moved[..., 2] * np.sin(turn)) * scale + PIXELS * FINER / 2
    y = PIXELS * FINER / 2 - moved[..., 1] * scale
    return x, y, moved[..., 0] * np.sin(turn) + moved[..., 2] * np.cos(turn)


def means(values):
    """Of each pixel's finer ones."""
    shape = (PIXELS, FINER, PIXELS, FINER) + values.shape[2:]
    return values.reshape(shape).mean(axis=(1, 3))


def draw_strands(strands, side, centre, scale):
    counts, positions, widths, colours = strands
    ends = np.cumsum(counts)
    begin = np.ones(len(positions), bool)
    begin[ends - 1] = False
    first = np.flatnonzero(begin)
    x, y, towards = projected(positions, side, centre, scale)
    steps = max(1, int(np.ceil(np.hypot(x[first + 1] - x[first], y[first + 1] - y[first]).max())))
    steps = min(steps, 24)
    size = PIXELS * FINER
    cover = np.zeros(size * size)
    nearest = np.full(size * size, -np.inf)
    seen = np.zeros((size * size, 3))
    length = np.hypot(x[first + 1] - x[first], y[first + 1] - y[first])
    for step in range(steps):
        part = (step + 0.5) / steps
        px = np.clip((x[first] * (1 - part) + x[first + 1] * part).astype(int), 0, size - 1)
        py = np.clip((y[first] * (1 - part) + y[first + 1] * part).astype(int), 0, size - 1)
        at = py * size + px
        width = widths[first] * (1 - part) + widths[first + 1] * part
        cover += np.bincount(at, length / steps * width * scale, size * size)
        depth = towards[first] * (1 - part) + towards[first + 1] * part
        order = np.argsort(depth)
        at, depth = at[order], depth[order]
        tint = (colours[first] * (1 - part) + colours[first + 1] * part)[order]
        front = np.zeros(size * size)
        front[:] = -np.inf
        front[at] = depth
        colour = np.zeros((size * size, 3))
        colour[at] = tint
        nearer = front > nearest
        nearest[nearer] = front[nearer]
        seen[nearer] = colour[nearer]
    alpha = 1 - np.exp(-cover)
    return shown(alpha.reshape(size, size), seen.reshape(size, size, 3))


def draw_cards(cards, side, centre, scale):
    size = PIXELS * FINER
    x, y, towards = projected(cards.corners, side, centre, scale)
    nearest = np.full((size, size), -np.inf)
    alpha = np.zeros((size, size))
    seen = np.zeros((size, size, 3))
    texels = cards.texels.shape[0]
    for i in range(len(x)):
        left, top = max(int(x[i].min()), 0), max(int(y[i].min()), 0)
        right, low = min(int(x[i].max()) + 1, size), min(int(y[i].max()) + 1, size)
        area = (x[i, 1] - x[i, 0]) * (y[i, 2] - y[i, 0]) - (x[i, 2] - x[i, 0]) * (y[i, 1] - y[i, 0])
        if right <= left or low <= top or abs(area) < 1e-9:
            continue
        px, py = np.meshgrid(np.arange(left, right) + 0.5, np.arange(top, low) + 0.5)
        b = ((px - x[i, 0]) * (y[i, 2] - y[i, 0]) - (x[i, 2] - x[i, 0]) * (py - y[i, 0])) / area
        c = ((x[i, 1] - x[i, 0]) * (py - y[i, 0]) - (px - x[i, 0]) * (y[i, 1] - y[i, 0])) / area
        a = 1 - b - c
        depth = a * towards[i, 0] + b * towards[i, 1] + c * towards[i, 2]
        window = np.s_[top:low, left:right]
        inside = (a >= 0) & (b >= 0) & (c >= 0) & (depth > nearest[window])
        if not inside.any():
            continue
        uv = a[inside, None] * cards.uvs[i, 0] + b[inside, None] * cards.uvs[i, 1] + c[inside, None] * cards.uvs[i, 2]
        texel = np.clip((uv * texels).astype(int), 0, texels - 1)
        texture = cards.texels[texel[:, 1], texel[:, 0]]
        solid = texture[:, 3] >= cards.cutoff
        rows, columns = np.nonzero(inside)
        rows, columns = rows[solid] + top, columns[solid] + left
        nearest[rows, columns] = depth[inside][solid]
        alpha[rows, columns] = 1.0
        seen[rows, columns] = texture[solid, :3]
    return shown(alpha, seen)


def shown(alpha, seen):
    weight = means(alpha)
    colour = means(seen * alpha[..., None]) / np.maximum(weight, 1e-6)[..., None]
    return weight, colour


def compare(strands, cards, sides=tuple(SIDES)):
    positions = strands[1]
    low, high = positions.min(axis=0), positions.max(axis=0)
    centre, extent = (low + high) / 2, max(high[1] - low[1], np.hypot(high[0] - low[0], high[2] - low[2]))
    scale = 0.94 * PIXELS * FINER / extent
    found, rows = {}, []
    for side in sides:
        hair, hair_colour = draw_strands(strands, side, centre, scale)
        card, card_colour = draw_cards(cards, side, centre, scale)
        both = (hair >= 0.5) & (card >= 0.5)
        either = (hair >= 0.5) | (card >= 0.5)
        first, second = hair_colour[hair >= 0.5].mean(axis=0), card_colour[card >= 0.5].mean(axis=0)
        found[side] = {"overlap": round(float(both.sum() / max(either.sum(), 1)), 4),
                       "cover": round(float(card.sum() / hair.sum()), 4),
                       "strands": first.round(4).tolist(), "cards": second.round(4).tolist(),
                       "away": round(float(np.linalg.norm(first - second) / np.linalg.norm(first)), 4)}
        grey = 0.75
        rows.append(np.concatenate([hair_colour * hair[..., None] + grey * (1 - hair[..., None]),
                                    card_colour * card[..., None] + grey * (1 - card[..., None])]))
    return found, np.concatenate(rows, axis=1)


def main():
    level = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    strands, cards = read_strands(sys.argv[1]), Cards(sys.argv[2], level)
    found, picture = compare(strands, cards)
    if len(sys.argv) > 3:
        flat = (picture.clip(0, 1) * 255).astype(np.uint8)
        with open(sys.argv[3], "wb") as file:
            file.write(b"P6 %d %d 255\n" % (flat.shape[1], flat.shape[0]) + flat.tobytes())
    first, second = cards.uvs[:, 1] - cards.uvs[:, 0], cards.uvs[:, 2] - cards.uvs[:, 0]
    filled = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]).sum() / 2
    print(json.dumps({"triangles": len(cards.corners), "filled": round(float(filled), 4), "sides": found}))


if __name__ == "__main__":
    main()
