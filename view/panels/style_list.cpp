// Folders and search over the library: see the header.
#include "view/panels/style_list.h"

#include "model/values/names.h"
#include "model/values/search_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::view {

namespace {

QStringList searchedTexts(const model::PresetEntry& entry)
{
    QStringList texts{model::shownName(entry.name)};
    for (const QString& tag : entry.tags)
        texts.append(model::shownName(tag));
    for (const model::StyleFolder& folder : model::styleFolders())
        if (folder.kind != model::StyleFolder::Kind::All && liesIn(folder, entry.tags, StyleList::isOwn(entry)))
            texts.append(folder.titleText());
    return texts;
}

} // namespace

const model::PresetEntry* StyleList::find(const QString& path) const
{
    const auto found = std::ranges::find(m_entries, path, &model::PresetEntry::path);
    return found != m_entries.end() ? &*found : nullptr;
}

std::vector<QString> StyleList::shown(const model::StyleFolder& folder, const QString& words) const
{
    std::vector<QString> paths;
    const auto addFound = [&](const model::PresetEntry& entry) {
        if (model::isFound(words, searchedTexts(entry)))
            paths.push_back(entry.path);
    };
    if (folder.kind == model::StyleFolder::Kind::Recent) {
        for (const QString& path : m_marks.recent)
            if (const model::PresetEntry* entry = find(path))
                addFound(*entry);
        return paths;
    }
    const bool isOfFavourites = folder.kind == model::StyleFolder::Kind::Favourites;
    for (const model::PresetEntry& entry : m_entries)
        if (isOfFavourites ? m_marks.favourites.contains(entry.path) : liesIn(folder, entry.tags, isOwn(entry)))
            addFound(entry);
    return paths;
}

void StyleMarks::setFavourite(const QString& path, bool favourite)
{
    favourites.removeAll(path);
    if (favourite)
        favourites.append(path);
    favourites = favourites.mid(std::max<qsizetype>(favourites.size() - kMostFavourites, 0));
}

void StyleMarks::addRecent(const QString& path)
{
    recent.removeAll(path);
    recent.prepend(path);
    recent = recent.mid(0, kMostRecent);
}

void StyleMarks::rename(const QString& before, const QString& after)
{
    for (QStringList* list : {&favourites, &recent})
        if (const qsizetype at = list->indexOf(before); at >= 0) {
            list->replace(at, after);
            list->removeDuplicates();
        }
}

StyleSign signOf(const model::StyleFolder& folder, const QString& words)
{
    using Kind = model::StyleFolder::Kind;
    const auto text = [](const char* source) { return QCoreApplication::translate("StyleStrip", source); };
    const QString all = text(QT_TRANSLATE_NOOP("StyleStrip", "Show all styles"));
    if (!words.isEmpty() && folder.kind == Kind::All)
        return {text(QT_TRANSLATE_NOOP("StyleStrip", "No style is found for '%1'")).arg(words), all};
    if (!words.isEmpty())
        return {
            text(QT_TRANSLATE_NOOP("StyleStrip", "No style in '%1' is found for '%2'")).arg(folder.titleText(), words),
            text(QT_TRANSLATE_NOOP("StyleStrip", "Search in all folders"))};
    if (folder.kind == Kind::Favourites)
        return {text(QT_TRANSLATE_NOOP("StyleStrip", "The star in a picture's corner brings a style here.")), all};
    if (folder.kind == Kind::Recent)
        return {text(QT_TRANSLATE_NOOP("StyleStrip", "Styles that you put on come here.")), all};
    return {text(QT_TRANSLATE_NOOP("StyleStrip", "There are no styles in this folder yet.")), all};
}

} // namespace hairpaint::view
