# Blender add-on: reads the `.hair` files that Hair Paint exports as a Curves object, with radius, colour and material.
# Blender 3.4 or later. Licence: MIT, as Hair Paint's.
import struct

import bpy
import numpy
from bpy_extras.io_utils import ImportHelper

bl_info = {
    "name": "Hair Paint hair (.hair)",
    "author": "Hair Paint",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Hair Paint hair (.hair)",
    "description": "Reads hair as curves with radius, colour and material",
    "category": "Import-Export",
}

HEADER_BYTES = 128
COLOUR_ATTRIBUTE = "hair_color"  # Cycles reads nothing from one that is called "color".
SEGMENTS, POINTS, THICKNESS, TRANSPARENCY, COLOURS = 1, 2, 4, 8, 16


class Hair:
    """What a file holds, in Blender's space: metres, z up."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        if len(data) < HEADER_BYTES or data[:4] != b"HAIR":
            raise ValueError("it is no .hair file; choose another")
        strands, points, flags, default_segments = struct.unpack_from("<4I", data, 4)
        width, transparency, *colour = struct.unpack_from("<5f", data, 20)
        text = data[40:HEADER_BYTES].split(b"\0")[0].decode("ascii", "replace")
        self.at = HEADER_BYTES

        def take(flag, kind, count, width_of_row, default):
            if not flags & flag:
                return numpy.broadcast_to(numpy.asarray(default, numpy.float32), (count, width_of_row))
            if self.at + count * width_of_row * numpy.dtype(kind).itemsize > len(data):
                raise ValueError("it is cut short; export it again")
            values = numpy.frombuffer(data, kind, count * width_of_row, self.at)
            self.at += values.nbytes
            return values.reshape(count, width_of_row)

        segments = take(SEGMENTS, "<u2", strands, 1, default_segments)[:, 0].astype(numpy.int64)
        if not flags & POINTS or int(segments.sum()) + strands != points:
            raise ValueError("its counts do not fit together; export it again")
        self.sizes = (segments + 1).tolist()
        unit = 0.01 if "centimetres" in text else 1.0
        positions = take(POINTS, "<f4", points, 3, 0.0).astype(numpy.float32) * unit
        if "z up" not in text:
            positions = numpy.stack((positions[:, 0], -positions[:, 2], positions[:, 1]), axis=1)
        self.positions = numpy.ascontiguousarray(positions)
        self.radius = numpy.ascontiguousarray(take(THICKNESS, "<f4", points, 1, width)[:, 0] * (0.5 * unit))
        self.alpha = 1.0 - take(TRANSPARENCY, "<f4", points, 1, transparency)[:, 0]
        encoded = take(COLOURS, "<f4", points, 3, colour)
        # The file's colours are sRGB as encoded; attributes are linear light.
        self.colour = numpy.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def add_curves(name, sizes):
    """A Curves object with so many points a curve, in the scene and active."""
    empty = bpy.data.hair_curves.new(name)
    if hasattr(empty, "add_curves"):
        empty.add_curves(sizes)
        made = bpy.data.objects.new(name, empty)
        bpy.context.collection.objects.link(made)
    else:
        # Blender 3.4 makes them from curves of the older kind alone.
        bpy.data.hair_curves.remove(empty)
        older = bpy.data.curves.new(name, "CURVE")
        older.dimensions = "3D"
        for size in sizes:
            older.splines.new("POLY").points.add(size - 1)
        made = bpy.data.objects.new(name, older)
        bpy.context.collection.objects.link(made)
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = made
    made.select_set(True)
    if made.type == "CURVE":
        bpy.ops.object.convert(target="CURVES")
        made = bpy.context.view_layer.objects.active
    return made


def set_attribute(curves, name, kind, key, values):
    attribute = curves.attributes.get(name) or curves.attributes.new(name, kind, "POINT")
    attribute.data.foreach_set(key, numpy.ascontiguousarray(values, numpy.float32).ravel())


def hair_material():
    material = bpy.data.materials.new("Hair")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    hair = nodes.new("ShaderNodeBsdfHairPrincipled")
    hair.parametrization = "COLOR"
    hair.location = (-300, 0)
    colour = nodes.new("ShaderNodeAttribute")
    colour.attribute_name = COLOUR_ATTRIBUTE
    colour.location = (-600, 0)
    links = material.node_tree.links
    links.new(colour.outputs["Color"], hair.inputs["Color"])
    links.new(hair.outputs["BSDF"], output.inputs["Surface"])
    return material


def read_hair(path, name):
    hair = Hair(path)
    made = add_curves(name, hair.sizes)
    curves = made.data
    set_attribute(curves, "position", "FLOAT_VECTOR", "vector", hair.positions)
    set_attribute(curves, "radius", "FLOAT", "value", hair.radius)
    set_attribute(curves, COLOUR_ATTRIBUTE, "FLOAT_COLOR", "color", numpy.column_stack((hair.colour, hair.alpha)))
    curves.materials.clear()
    curves.materials.append(hair_material())
    curves.update_tag()
    return made


class ImportHairPaint(bpy.types.Operator, ImportHelper):
    """Read hair as curves with radius, colour and material"""

    bl_idname = "import_curves.hair_paint"
    bl_label = "Import Hair Paint hair"
    bl_options = {"REGISTER", "UNDO"}
    filename_ext = ".hair"
    filter_glob: bpy.props.StringProperty(default="*.hair", options={"HIDDEN"})

    def execute(self, context):
        try:
            read_hair(self.filepath, bpy.path.display_name_from_filepath(self.filepath))
        except (OSError, ValueError) as problem:
            reason = getattr(problem, "strerror", None) or problem
            self.report({"ERROR"}, f"'{self.filepath}' can't be read: {reason}.")
            return {"CANCELLED"}
        return {"FINISHED"}


def add_to_menu(menu, _context):
    menu.layout.operator(ImportHairPaint.bl_idname, text="Hair Paint hair (.hair)")


def register():
    bpy.utils.register_class(ImportHairPaint)
    bpy.types.TOPBAR_MT_file_import.append(add_to_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(add_to_menu)
    bpy.utils.unregister_class(ImportHairPaint)


if __name__ == "__main__":
    register()
