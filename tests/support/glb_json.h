// The JSON of a binary glTF, read and changed.
#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

#include <functional>

namespace hairpaint::test {

inline QJsonObject jsonOf(const QByteArray& glb)
{
    return QJsonDocument::fromJson(glb.sliced(20, qFromLittleEndian<quint32>(glb.constData() + 12))).object();
}

/// A glb with another JSON chunk.
inline QByteArray withJson(const QByteArray& glb, const std::function<void(QJsonObject&)>& change)
{
    const auto word = [](qsizetype number) {
        const quint32 little = qToLittleEndian(static_cast<quint32>(number));
        return QByteArray(reinterpret_cast<const char*>(&little), 4);
    };
    QJsonObject root = jsonOf(glb);
    change(root);
    QByteArray json = QJsonDocument(root).toJson(QJsonDocument::Compact);
    while (json.size() % 4 != 0)
        json.append(' ');
    const QByteArray bin = glb.sliced(20 + qFromLittleEndian<quint32>(glb.constData() + 12));
    return glb.first(8) + word(20 + json.size() + bin.size()) + word(json.size()) + glb.sliced(16, 4) + json + bin;
}

/// One key of a node.
inline void changeNode(QJsonObject& json, int number, const QString& key, const QJsonValue& value)
{
    QJsonArray nodes = json[QLatin1String("nodes")].toArray();
    QJsonObject node = nodes[number].toObject();
    node[key] = value;
    nodes[number] = node;
    json[QLatin1String("nodes")] = nodes;
}

/// Its number.
inline int addNode(QJsonObject& json, const QJsonObject& node)
{
    QJsonArray nodes = json[QLatin1String("nodes")].toArray();
    nodes.append(node);
    json[QLatin1String("nodes")] = nodes;
    return static_cast<int>(nodes.size()) - 1;
}

} // namespace hairpaint::test
