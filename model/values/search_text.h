// How what people type is compared with names.
#pragma once

#include <QString>
#include <QStringList>

namespace hairpaint::model {

/// Without case, diacritics and the differences between forms of one letter: "Árbol" is "arbol".
[[nodiscard]] QString searchForm(const QString& text);

/// Whether every word of `words` occurs in one of the texts, in any order; no words occur everywhere.
[[nodiscard]] bool isFound(const QString& words, const QStringList& texts);

} // namespace hairpaint::model
