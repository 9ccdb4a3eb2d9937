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
        Favourites, ///< What the user has marked, as a list of its own tells.
        Recent,     ///< What was put on last, likewise.
        Tagged,
        Own
    };
    Kind kind;
    const char* title;                       ///< To be translated in context "StyleFolders".
    std::span<const char* const> tags = {};  ///< Of a tagged folder, as files have them.
    [[nodiscard]] QString titleText() const; ///< Translated.
};

[[nodiscard]] std::span<const StyleFolder> styleFolders(); ///< As they stand side by side; the first holds all.

/// Whether a style of these tags lies in it; never in the two whose lists the user makes.
[[nodiscard]] bool liesIn(const StyleFolder& folder, const QStringList& tags, bool own);

} // namespace hairpaint::model
