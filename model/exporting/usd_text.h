// What USD's text form is put together from (openusd.org, "Crate and text file formats").
#pragma once

#include <QSet>
#include <QString>

#include <glm/glm.hpp>

#include <string>

namespace hairpaint::model {

/// As a name of a prim, letters, digits and underscores, that is not among those taken; is added to them.
[[nodiscard]] QString usdName(const QString& name, QSet<QString>& taken);
/// A string in quotation marks, without control characters.
[[nodiscard]] std::string usdQuoted(const QString& text);
/// "(x,y,z)", each the shortest number that reads back as the same float.
void appendUsdPoint(std::string& out, const glm::vec3& point);
/// The same with four digits after the point, for 0..1.
void appendUsdColour(std::string& out, const glm::vec3& colour);

} // namespace hairpaint::model
