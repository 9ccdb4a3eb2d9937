// The sentences.
#include "model/repair/losses.h"

#include "model/project/group_schema.h"
#include "model/values/names.h"
#include "model/values/sentences.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

struct SettingLoss
{
    const char* key;      ///< Key in the root object of project.json.
    const char* sentence; ///< To be translated in context "Files".
};

constexpr std::array<SettingLoss, 9> kSettingLosses = {{
    {"background", QT_TRANSLATE_NOOP("Files", "Its background colour is lost; the usual takes its place.")},
    {"ellipsoids", QT_TRANSLATE_NOOP("Files", "Its colliders are lost; the usual ones take their place.")},
    {"head", QT_TRANSLATE_NOOP("Files", "The name, unit and landmarks of its head are lost; they are guessed anew.")},
    {"light", QT_TRANSLATE_NOOP("Files", "Its light is lost; the usual takes its place.")},
    {"max_hairs", QT_TRANSLATE_NOOP("Files", "Its limit on hair candidates is lost; the usual takes its place.")},
    {"seed",
     QT_TRANSLATE_NOOP("Files", "The seed of its roots is lost; the usual takes its place, and each hair stands "
                                "elsewhere.")},
    {"skin", QT_TRANSLATE_NOOP("Files", "Its skin tone is lost; the usual takes its place.")},
    {"wind", QT_TRANSLATE_NOOP("Files", "Its wind is lost; the usual takes its place.")},
    {"worn", QT_TRANSLATE_NOOP("Files", "What is worn in the hair is lost.")},
}};

/// As the window calls it.
QString settingTitle(const QString& key)
{
    if (key == QLatin1String("name"))
        return say(QT_TRANSLATE_NOOP("Files", "Name"));
    if (key == QLatin1String("visible"))
        return say(QT_TRANSLATE_NOOP("Files", "Visibility"));
    const auto found = std::ranges::find_if(
        groupSchema(), [&key](const GroupSetting& row) { return key == QLatin1StringView(row.key); });
    return found != groupSchema().end() ? schemaText(found->label) : key;
}

/// As it stands in a sentence.
QString quotedName(const QString& name)
{
    return shownPath(shownName(name));
}

QString layerPropertiesText(const QString& group, const MapSpec& spec, const QString& layer)
{
    return say(QT_TRANSLATE_NOOP("Files",
                                 "Name, order and blending of the layer '%3' of %2 in the group '%1' are lost; "
                                 "its paint is there."))
        .arg(quotedName(group), spec.titleText(), quotedName(layer));
}

} // namespace

void Losses::add(const QString& sentence)
{
    if (!m_sentences.contains(sentence))
        m_sentences.append(sentence);
}

void Losses::setting(const QString& key)
{
    const auto* const found = std::ranges::find_if(
        kSettingLosses, [&key](const SettingLoss& loss) { return key == QLatin1StringView(loss.key); });
    Q_ASSERT(found != kSettingLosses.end());
    add(say(found->sentence));
}

void Losses::head(const QString& name)
{
    add(name.isEmpty()
            ? say(QT_TRANSLATE_NOOP("Files", "Its head is lost; that of a new project takes its place."))
            : say(QT_TRANSLATE_NOOP("Files", "Its head '%1' is lost; that of a new project takes its place."))
                  .arg(quotedName(name)));
}

void Losses::ownMesh(const QString& name)
{
    add(say(QT_TRANSLATE_NOOP("Files", "The mesh '%1' that is worn is lost; put it on anew.")).arg(quotedName(name)));
}

void Losses::groupSettings(const QString& group)
{
    add(say(QT_TRANSLATE_NOOP("Files", "Settings of the group '%1' are lost; the usual ones take their place."))
            .arg(quotedName(group)));
}

void Losses::groupSetting(const QString& group, const QString& key)
{
    add(say(QT_TRANSLATE_NOOP("Files", "'%2' of the group '%1' is lost; the usual takes its place."))
            .arg(quotedName(group), quotedName(settingTitle(key))));
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
    add(layerPropertiesText(group, spec, layer));
}

void Losses::layer(const QString& group, const MapSpec& spec, const QString& layer)
{
    // The layer's properties are no loss where all of its paint is lost.
    m_sentences.removeAll(layerPropertiesText(group, spec, layer));
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
