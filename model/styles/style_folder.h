// Folders of the library of styles: one table, which tags fill.
#pragma once

#include <QString>
#include <QStringList>

#include <cstdint>
#include <span>

namespace hairpaint::model {

/// A row of the table. A style lies in every folder that one of its tags belongs to.
struct StyleFolder
{
    enum class Kind : std::uint8_t
    {
        All,
        Favourites, ///< Styles that the user has marked; they are kept in a list of their own.
        Recent,     ///< Styles that were put on last; they are kept in a list of their own.
        Tagged,
        Own
    };
    Kind kind;
    const char* title;                       ///< To be translated in context "StyleFolders".
    std::span<const char* const> tags = {};  ///< Tags of a tagged folder, as files have them; empty for other kinds.
    [[nodiscard]] QString titleText() const; ///< Translated.
};

/// In the order in which they are shown; the first holds all styles.
[[nodiscard]] std::span<const StyleFolder> styleFolders();

/// Whether a style with these tags belongs to the folder; false for Favourites and Recent, whose lists tell.
[[nodiscard]] bool liesIn(const StyleFolder& folder, const QStringList& tags, bool own);

} // namespace hairpaint::model
