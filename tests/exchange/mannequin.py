"""Writes a body with a skeleton as a GLB: mannequin.py FILE.glb

A ball for a head on boxes for limbs; its arms hang as those of an A, its uv has the head on all but the lowest twentieth.
Each joint is turned differently, and its mesh hangs from a node that is moved, which glTF says is not to be minded.
"""
import json
import math
import struct
import sys

DROOP = 0.7
JOINTS = [("pelvis", -1, (0, .95, 0)), ("spine_01", 0, (0, 1.05, 0)), ("spine_02", 1, (0, 1.15, 0)),
          ("spine_03", 2, (0, 1.25, 0)), ("neck_01", 3, (0, 1.42, 0)), ("head", 4, (0, 1.5, 0))]
HEAD = 5
for letter, sign in (("l", 1), ("r", -1)):
    at = len(JOINTS)
    reach = lambda d: (sign * (.18 + d * math.cos(DROOP)), 1.4 - d * math.sin(DROOP), 0)
    JOINTS += [(f"clavicle_{letter}", 3, (sign * .05, 1.4, 0)), (f"upperarm_{letter}", at, reach(0)),
               (f"lowerarm_{letter}", at + 1, reach(.27)), (f"hand_{letter}", at + 2, reach(.52)),
               (f"thigh_{letter}", 0, (sign * .1, .9, 0)), (f"calf_{letter}", at + 4, (sign * .1, .5, 0)),
               (f"foot_{letter}", at + 5, (sign * .1, .08, 0))]


def turn_of(index):
    """A quaternion x, y, z, w."""
    angle = .2 * index
    return (math.sin(angle / 2) * .6, 0, math.sin(angle / 2) * .8, math.cos(angle / 2))


def product(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


def back(q):
    return (-q[0], -q[1], -q[2], q[3])


def turned(q, v):
    return product(product(q, (*v, 0)), back(q))[:3]


def body():
    """Positions, normals, uvs, joints and triangles."""
    found = ([], [], [], [], [])
    positions, normals, uvs, joints, triangles = found
    columns, rows = 96, 48
    for row in range(rows + 1):
        for column in range(columns + 1):
            u, v = column / columns, row / rows
            latitude, longitude = (v - .5) * math.pi, (u - .5) * 2 * math.pi
            normal = (math.cos(latitude) * math.sin(longitude), math.sin(latitude),
                      math.cos(latitude) * math.cos(longitude))
            positions.append((.1 * normal[0], 1.62 + .13 * normal[1], .11 * normal[2]))
            normals.append(normal)
            uvs.append((u, 1 - (.05 + .95 * v)))
            joints.append(HEAD)
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            triangles += [(a, a + 1, a + columns + 2), (a, a + columns + 2, a + columns + 1)]
    for index, (_, parent, end) in enumerate(JOINTS):
        if parent < 0:
            continue
        start = JOINTS[parent][2]
        low = [min(p, q) - .03 for p, q in zip(start, end)]
        size = [max(p, q) + .03 - l for p, q, l in zip(start, end, low)]
        for axis in range(3):
            for far in (0, 1):
                first = len(positions)
                for corner in range(4):
                    unit, normal = [0, 0, 0], [0, 0, 0]
                    unit[axis], unit[(axis + 1) % 3], unit[(axis + 2) % 3] = far, corner % 2, corner // 2
                    normal[axis] = 2 * far - 1
                    positions.append(tuple(l + s * u for l, s, u in zip(low, size, unit)))
                    normals.append(tuple(normal))
                    uvs.append((.045 * index + .04 * (corner % 2), 1 - .04 * (corner // 2)))
                    joints.append(parent)
                faces = [(0, 1, 3), (0, 3, 2)] if far else [(0, 3, 1), (0, 2, 3)]
                triangles.extend(tuple(first + i for i in face) for face in faces)
    return found


def nodes_of(first):
    nodes = []
    for index, (name, parent, position) in enumerate(JOINTS):
        above = turn_of(parent) if parent >= 0 else (0, 0, 0, 1)
        start = JOINTS[parent][2] if parent >= 0 else (0, 0, 0)
        node = {"name": name, "translation": turned(back(above), [p - q for p, q in zip(position, start)]),
                "rotation": product(back(above), turn_of(index))}
        children = [first + i for i, (_, other, _) in enumerate(JOINTS) if other == index]
        if children:
            node["children"] = children
        nodes.append(node)
    return nodes


def inverse_bind(index):
    """Column by column."""
    q = back(turn_of(index))
    columns = [(*turned(q, axis), 0) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    position = turned(q, [-p for p in JOINTS[index][2]])
    return [number for column in columns for number in column] + [*position, 1]


def main():
    positions, normals, uvs, joints, triangles = body()
    chunk, views, accessors = b"", [], []

    def add(form, rows, kind, component):
        nonlocal chunk
        data = b"".join(struct.pack(form, *row) for row in rows)
        views.append({"buffer": 0, "byteOffset": len(chunk), "byteLength": len(data)})
        chunk += data + bytes(-len(data) % 4)
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(rows), "type": kind})
        return len(accessors) - 1

    attributes = {"POSITION": add("<3f", positions, "VEC3", 5126), "NORMAL": add("<3f", normals, "VEC3", 5126),
                  "TEXCOORD_0": add("<2f", uvs, "VEC2", 5126),
                  "JOINTS_0": add("<4H", [(j, 0, 0, 0) for j in joints], "VEC4", 5123),
                  "WEIGHTS_0": add("<4f", [(1, 0, 0, 0)] * len(joints), "VEC4", 5126)}
    accessors[0] |= {"min": [min(p[i] for p in positions) for i in range(3)],
                     "max": [max(p[i] for p in positions) for i in range(3)]}
    indices = add("<I", [(i,) for triangle in triangles for i in triangle], "SCALAR", 5125)
    binds = add("<16f", [inverse_bind(i) for i in range(len(JOINTS))], "MAT4", 5126)
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"name": "Armature", "children": [1, 2]},
                      {"name": "Body", "mesh": 0, "skin": 0, "translation": [3, 2, 1]}, *nodes_of(2)],
            "skins": [{"joints": [2 + i for i in range(len(JOINTS))], "inverseBindMatrices": binds}],
            "meshes": [{"primitives": [{"attributes": attributes, "indices": indices}]}],
            "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(chunk)}]}
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    with open(sys.argv[1], "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(chunk)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(chunk), b"BIN\0") + chunk)


if __name__ == "__main__":
    main()
