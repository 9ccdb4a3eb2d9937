// The styles that the strip knows, and which of them a folder and a search show.
#pragma once

#include "model/files/preset_file.h"
#include "model/styles/style_folder.h"

#include <QStringList>

#include <vector>

namespace hairpaint::view {

/// What a user keeps of the library, by path; a style that is gone for now stays in it.
struct StyleMarks
{
    static constexpr qsizetype kMostFavourites = 1000;
    static constexpr qsizetype kMostRecent = 12;

    QStringList favourites;
    QStringList recent; ///< Put on last first.

    void setFavourite(const QString& path, bool favourite);
    void addRecent(const QString& path);
    void rename(const QString& before, const QString& after);
    friend bool operator==(const StyleMarks&, const StyleMarks&) = default;
};

/// What stands where a folder shows no style, and the text of the button that leads on.
struct StyleSign
{
    QString sentence;
    QString button;
};
/// `words`: searched for; empty: none.
[[nodiscard]] StyleSign signOf(const model::StyleFolder& folder, const QString& words);

/// GUI thread, since texts are compared in the user's language.
class StyleList
{
public:
    void setEntries(std::vector<model::PresetEntry> entries) { m_entries = std::move(entries); }
    [[nodiscard]] const std::vector<model::PresetEntry>& entries() const { return m_entries; }
    [[nodiscard]] const model::PresetEntry* find(const QString& path) const; ///< Null where there is none.

    [[nodiscard]] StyleMarks& marks() { return m_marks; }

    /// Paths, in the library's order, or as they were put on. A search looks at name, tags and folders as they are
    /// shown.
    [[nodiscard]] std::vector<QString> shown(const model::StyleFolder& folder, const QString& words) const;

    [[nodiscard]] static bool isOwn(const model::PresetEntry& entry) { return entry.folder == QLatin1String("own"); }

private:
    std::vector<model::PresetEntry> m_entries;
    StyleMarks m_marks;
};

} // namespace hairpaint::view
