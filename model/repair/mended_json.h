// A project.json that can be read again: what is wrong in it is left out, and said.
// Any thread. Errors: none; what it gives may still be refused where there is too much of it.
#pragma once

#include "model/repair/losses.h"

#include <QByteArray>
#include <QJsonObject>

#include <functional>

namespace hairpaint::model {

/// The object with what stands before the first character at which the text is no JSON; empty where that is nothing.
struct CutJson
{
    QJsonObject root;
    bool isWhole = false; ///< There is no such character.
};
[[nodiscard]] CutJson jsonAsFarAsItGoes(const QByteArray& json);

/// The side that the image of a layer has, for maps whose size is lost; 0 where that is not known.
using SizeOfLayer = std::function<int(Id group, const QString& map, Id layer)>;

/// The root without what projectFromJson refuses. It may be without a group, which is refused.
[[nodiscard]] QJsonObject mendedJson(const CutJson& json, const SizeOfLayer& sizeOfLayer, Losses& losses);

} // namespace hairpaint::model
