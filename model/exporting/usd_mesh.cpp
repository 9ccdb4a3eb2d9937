// UsdGeomMesh and UsdPreviewSurface (openusd.org).
#include "model/exporting/usd_mesh.h"

#include "model/exporting/piece_writer.h"
#include "model/exporting/usd_text.h"
#include "model/values/srgb.h"

#include <cstdint>
#include <vector>

namespace hairpaint::model {

namespace {

/// "        TYPE[] NAME = [A,B]", per vertex where `varies`.
template<typename T, typename Append>
void appendArray(std::string& out, const char* typedName, const std::vector<T>& values, bool varies,
                 const Append& append)
{
    out += std::string("        ") + typedName + " = [";
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0)
            out.push_back(',');
        append(values[i]);
    }
    out += varies ? "] (\n            interpolation = \"vertex\"\n        )\n" : "]\n";
}

std::string linearColour(QRgb colour)
{
    const auto linear = [](int channel) { return linearFromSrgb(static_cast<float>(channel) / 255.0F); };
    std::string out;
    appendUsdColour(out, {linear(qRed(colour)), linear(qGreen(colour)), linear(qBlue(colour))});
    return out;
}

/// What the image is shown by: its file, and the uvs that it lies by.
std::string pictureOf(const WornBody& body, const std::string& path, const QString& image)
{
    const auto linear = [](int channel) { return linearFromSrgb(static_cast<float>(channel) / 255.0F); };
    std::string scale;
    for (const int channel : {qRed(body.colour), qGreen(body.colour), qBlue(body.colour)}) {
        appendNumber(scale, linear(channel));
        scale.push_back(',');
    }
    return "\n            def Shader \"Picture\"\n            {\n"
           "                uniform token info:id = \"UsdUVTexture\"\n"
           "                asset inputs:file = @@@./" +
           image.toStdString() + "@@@\n                float4 inputs:scale = (" + scale +
           "1)\n                token inputs:sourceColorSpace = \"sRGB\"\n"
           "                float2 inputs:st.connect = <" +
           path +
           "/Material/Uv.outputs:result>\n"
           "                token inputs:wrapS = \"repeat\"\n                token inputs:wrapT = \"repeat\"\n"
           "                float outputs:a\n                float3 outputs:rgb\n            }\n\n"
           "            def Shader \"Uv\"\n            {\n"
           "                uniform token info:id = \"UsdPrimvarReader_float2\"\n"
           "                string inputs:varname = \"st\"\n                float2 outputs:result\n            }\n";
}

std::string materialOf(const WornBody& body, const std::string& path, const QString& image)
{
    std::string out = "        def Material \"Material\"\n        {\n            token outputs:surface.connect = <" +
                      path +
                      "/Material/Surface.outputs:surface>\n\n            def Shader \"Surface\"\n            {\n"
                      "                uniform token info:id = \"UsdPreviewSurface\"\n"
                      "                color3f inputs:diffuseColor";
    out +=
        image.isEmpty() ? " = " + linearColour(body.colour) : ".connect = <" + path + "/Material/Picture.outputs:rgb>";
    out += "\n                float inputs:metallic = 0\n";
    if (body.alpha != sim::TextureAlpha::Opaque)
        out += "                float inputs:opacity.connect = <" + path + "/Material/Picture.outputs:a>\n";
    if (body.alpha == sim::TextureAlpha::Mask)
        out += "                float inputs:opacityThreshold = 0.5\n";
    out += "                float inputs:roughness = ";
    appendNumber(out, static_cast<float>(body.roughness));
    out += "\n                token outputs:surface\n            }\n";
    if (!image.isEmpty())
        out += pictureOf(body, path, image);
    return out + "        }\n";
}

} // namespace

std::string usdMesh(const WornBody& body, const QString& name, const QString& image, const ExportSpace& space)
{
    const PosedMesh& mesh = body.mesh;
    const std::string path = "/Hair/" + name.toStdString();
    std::string out = "\n    def Mesh ";
    out += usdQuoted(name);
    out += " (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {\n"
           "        uniform token subdivisionScheme = \"none\"\n";
    if (body.isOpen)
        out += "        uniform bool doubleSided = true\n";
    out += "        rel material:binding = <";
    out += path;
    out += "/Material>\n";
    appendArray(out, "int[] faceVertexCounts", std::vector<int>(mesh.indices.size() / 3), false,
                [&out](int /*face*/) { out.push_back('3'); });
    appendArray(out, "int[] faceVertexIndices", mesh.indices, false,
                [&out](std::uint32_t index) { appendNumber(out, std::uint64_t{index}); });
    appendArray(out, "point3f[] points", mesh.vertices, false,
                [&](const HeadVertexOut& vertex) { appendUsdPoint(out, space.position(vertex.position)); });
    appendArray(out, "normal3f[] normals", mesh.vertices, true,
                [&](const HeadVertexOut& vertex) { appendUsdPoint(out, space.direction(vertex.normal)); });
    appendArray(out, "texCoord2f[] primvars:st", mesh.vertices, true, [&out](const HeadVertexOut& vertex) {
        out.push_back('(');
        appendNumber(out, vertex.uv.x);
        out.push_back(',');
        appendNumber(out, 1.0F - vertex.uv.y); // glTF's v points down.
        out.push_back(')');
    });
    out += "        color3f[] primvars:displayColor = [" + linearColour(meanColour(body)) +
           "] (\n            interpolation = \"constant\"\n        )\n\n";
    return out + materialOf(body, path, image) + "    }\n";
}

} // namespace hairpaint::model
