// What a repair could not bring back, in sentences for the user.
#pragma once

#include "model/project/project.h"

#include <QStringList>

namespace hairpaint::model {

class Losses
{
public:
    /// A key of project.json, outside the groups: one that mendedJson looks at, or "head".
    void setting(const QString& key);
    void head(const QString& name);
    void ownMesh(const QString& name); ///< A mesh that is worn.
    /// All of them, or some: where the JSON ends, they have their usual values.
    void groupSettings(const QString& group);
    /// `key`: "name", "visible", or one of groupSchema().
    void groupSetting(const QString& group, const QString& key);
    void group(qsizetype number);
    void map(const QString& group, const QString& id);
    /// Name, order and blending. Where the paint is lost, too, only that is said.
    void layerProperties(const QString& group, const MapSpec& spec, const QString& layer);
    void layer(const QString& group, const MapSpec& spec, const QString& layer);
    /// `rows` of `size` are left, from the top.
    void layerRows(const QString& group, const MapSpec& spec, const QString& layer, int rows, int size);
    /// The JSON, or its checksum, is not what was written.
    void unproven();

    [[nodiscard]] const QStringList& sentences() const { return m_sentences; }

private:
    void add(const QString& sentence);
    QStringList m_sentences;
};

} // namespace hairpaint::model
