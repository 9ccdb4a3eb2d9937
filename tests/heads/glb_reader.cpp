// The reader's checks: header, two chunks, one primitive, five accessors with a buffer view each.
#include "glb_reader.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>
#include <cstring>

namespace hairpaint::tests {

namespace {

using namespace Qt::StringLiterals;

constexpr int floatType = 5126;
constexpr int uintType = 5125;

struct Container
{
    QString error;
    QJsonObject json;
    QByteArray binary;
};

quint32 wordAt(const QByteArray& bytes, qsizetype at)
{
    return qFromLittleEndian<quint32>(bytes.constData() + at);
}

Container opened(const QByteArray& file)
{
    if (file.size() < 28 || !file.startsWith("glTF") || wordAt(file, 4) != 2 || wordAt(file, 8) != file.size())
        return {u"not a whole glTF 2 binary"_s, {}, {}};
    const qsizetype jsonSize = wordAt(file, 12);
    if (file.mid(16, 4) != "JSON" || jsonSize % 4 != 0 || 28 + jsonSize > file.size())
        return {u"no JSON chunk first"_s, {}, {}};
    const qsizetype binaryAt = 20 + jsonSize;
    if (file.mid(binaryAt + 4, 4) != QByteArray("BIN\0", 4) || binaryAt + 8 + wordAt(file, binaryAt) != file.size())
        return {u"not exactly one BIN chunk after it"_s, {}, {}};
    return {{}, QJsonDocument::fromJson(file.mid(20, jsonSize)).object(), file.mid(binaryAt + 8)};
}

template<typename T>
QString read(const Container& glb, const QJsonValue& accessorIndex, int componentType, QStringView type,
             std::vector<T>& out)
{
    const QJsonObject accessor = glb.json["accessors"_L1][accessorIndex.toInt(-1)].toObject();
    const QJsonObject view = glb.json["bufferViews"_L1][accessor["bufferView"_L1].toInt(-1)].toObject();
    if (accessor["componentType"_L1].toInt() != componentType || accessor["type"_L1].toString() != type)
        return u"an accessor has another type"_s;
    const qsizetype componentSize = 4;
    const qsizetype components = type == u"VEC3" ? 3 : type == u"VEC2" ? 2 : 1;
    const qsizetype size = accessor["count"_L1].toInteger() * components * componentSize;
    const qsizetype offset = view["byteOffset"_L1].toInteger();
    if (size != view["byteLength"_L1].toInteger() || offset % 4 != 0 || offset + size > glb.binary.size() ||
        static_cast<std::size_t>(size) % sizeof(T) != 0)
        return u"a buffer view does not fit its accessor"_s;
    out.resize(static_cast<std::size_t>(size) / sizeof(T));
    std::memcpy(out.data(), glb.binary.constData() + offset, static_cast<std::size_t>(size));
    return {};
}

glm::vec3 vector(const QJsonValue& value)
{
    return {static_cast<float>(value[0].toDouble()), static_cast<float>(value[1].toDouble()),
            static_cast<float>(value[2].toDouble())};
}

} // namespace

GlbMesh readGlb(const QByteArray& file)
{
    GlbMesh mesh;
    const Container glb = opened(file);
    const QJsonArray primitives = glb.json["meshes"_L1][0]["primitives"_L1].toArray();
    if (!glb.error.isEmpty() || glb.json["meshes"_L1].toArray().size() != 1 || primitives.size() != 1 ||
        primitives[0]["mode"_L1].toInt() != 4) {
        mesh.error = glb.error.isEmpty() ? u"not one mesh of one primitive of triangles"_s : glb.error;
        return mesh;
    }
    const QJsonObject primitive = primitives[0].toObject();
    const QJsonObject attributes = primitive["attributes"_L1].toObject();
    for (const QString& error : {read(glb, primitive["indices"_L1], uintType, u"SCALAR", mesh.triangles),
                                 read(glb, attributes["POSITION"_L1], floatType, u"VEC3", mesh.positions),
                                 read(glb, attributes["NORMAL"_L1], floatType, u"VEC3", mesh.normals),
                                 read(glb, attributes["TEXCOORD_0"_L1], floatType, u"VEC2", mesh.texCoords),
                                 read(glb, attributes["_UV"_L1], floatType, u"VEC2", mesh.uvs)})
        if (!error.isEmpty())
            mesh.error = error;
    const QJsonValue positions = glb.json["accessors"_L1][attributes["POSITION"_L1].toInt()];
    mesh.declaredLow = vector(positions["min"_L1]);
    mesh.declaredHigh = vector(positions["max"_L1]);
    const std::size_t count = mesh.positions.size();
    if (mesh.normals.size() != count || mesh.texCoords.size() != count || mesh.uvs.size() != count)
        mesh.error = u"attributes differ in count"_s;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= count)
                mesh.error = u"an index is out of range"_s;
    return mesh;
}

} // namespace hairpaint::tests
