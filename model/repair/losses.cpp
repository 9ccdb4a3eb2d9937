// The sentences.
#include "model/repair/losses.h"

#include "model/files/sentences.h"
#include "model/names.h"

#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::model {

namespace {

/// As it stands in a sentence.
QString quotedName(const QString& name)
{
    return shownPath(shownName(name));
}

} // namespace

void Losses::add(const QString& sentence)
{
    if (!m_sentences.contains(sentence))
        m_sentences.append(sentence);
}

void Losses::setting(const QString& key)
{
    add(say(QT_TRANSLATE_NOOP("Files", "What it said of '%1' is lost; the usual takes its place.")).arg(key));
}

void Losses::head(const QString& name)
{
    add(name.isEmpty()
            ? say(QT_TRANSLATE_NOOP("Files", "Its head is lost; that of a new project takes its place."))
            : say(QT_TRANSLATE_NOOP("Files", "Its head '%1' is lost; that of a new project takes its place."))
                  .arg(quotedName(name)));
}

void Losses::groupSettings(const QString& group)
{
    add(say(QT_TRANSLATE_NOOP("Files", "Settings of the group '%1' are lost; the usual ones take their place."))
            .arg(quotedName(group)));
}

void Losses::groupSetting(const QString& group, const QString& key)
{
    add(say(QT_TRANSLATE_NOOP("Files", "'%2' of the group '%1' is lost; the usual takes its place."))
            .arg(quotedName(group), quotedName(key)));
}

void Losses::group(qsizetype number)
{
    add(say(QT_TRANSLATE_NOOP("Files", "Group number %1 is lost.")).arg(number));
}

void Losses::map(const QString& group, const QString& id)
{
    add(say(QT_TRANSLATE_NOOP("Files", "The map '%2' of the group '%1' is lost."))
            .arg(quotedName(group), quotedName(id)));
}

void Losses::layerProperties(const QString& group, const MapSpec& spec, const QString& layer)
{
    add(say(QT_TRANSLATE_NOOP("Files", "Name, order and blending of the layer '%3' of %2 in the group '%1' are lost; "
                                       "its paint is there."))
            .arg(quotedName(group), spec.titleText(), quotedName(layer)));
}

void Losses::layer(const QString& group, const MapSpec& spec, const QString& layer)
{
    add(say(QT_TRANSLATE_NOOP("Files", "The paint of the layer '%3' of %2 in the group '%1' is lost."))
            .arg(quotedName(group), spec.titleText(), quotedName(layer)));
}

void Losses::layerRows(const QString& group, const MapSpec& spec, const QString& layer, int rows, int size)
{
    const int lostPercent = std::max(1, 100 - 100 * rows / size);
    add(say(QT_TRANSLATE_NOOP("Files", "The lower %4 % of the paint of the layer '%3' of %2 in the group '%1' are "
                                       "lost."))
            .arg(quotedName(group), spec.titleText(), quotedName(layer), QString::number(lostPercent)));
}

void Losses::unproven()
{
    add(say(QT_TRANSLATE_NOOP("Files", "Its settings don't agree with their checksum; look over those that are "
                                       "there.")));
}

} // namespace hairpaint::model
