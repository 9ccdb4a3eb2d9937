// Groups added, removed, renamed, moved, shown and replaced by a preset's.
#include "model/document/group_commands.h"

#include "model/document/command_texts.h"
#include "model/document/edit_command.h"
#include "model/document/range_change.h"
#include "model/styles/group_adoption.h"
#include "model/styles/hair_kinds.h"
#include "model/values/names.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

CommandPtr groupsCommand(Document& document, Id group, const QString& text, std::function<void(Project&)> edit)
{
    return editCommand(document, {.aspect = Change::Aspect::GroupList, .group = group}, text, std::move(edit));
}

/// Null where there is none to add.
CommandPtr addGroupsCommand(Document& document, std::vector<HairGroup> groups, const QString& text)
{
    if (groups.empty())
        return nullptr;
    return groupsCommand(document, 0, text, [groups = std::move(groups)](Project& project) {
        for (const HairGroup& group : groups)
            adoptGroup(project, group);
    });
}

QString nameOf(const Document& document, Id id)
{
    const HairGroup* group = document.committed().group(id);
    return group != nullptr ? shownName(group->name) : QString();
}

} // namespace

CommandPtr addGroupCommand(Document& document, const QString& name, const sim::GroupSettings& settings)
{
    return groupsCommand(document, 0, Commands::tr("Add group \"%1\"").arg(shownName(name)),
                         [name, settings](Project& project) {
                             project.groups.push_back(makeGroup(project, name));
                             project.groups.back().settings = settings;
                         });
}

CommandPtr addGroupCommand(Document& document, HairGroup group)
{
    const QString text = Commands::tr("Add group \"%1\"").arg(shownName(group.name));
    return groupsCommand(document, 0, text,
                         [group = std::move(group)](Project& project) { adoptGroup(project, group); });
}

CommandPtr importHairCommand(Document& document, std::vector<HairGroup> groups, const QString& fileName)
{
    return addGroupsCommand(document, std::move(groups), Commands::tr("Import %1").arg(shownName(fileName)));
}

CommandPtr addFaceHairCommand(Document& document, std::vector<HairGroup> groups)
{
    return addGroupsCommand(document, std::move(groups), Commands::tr("Add brows and lashes"));
}

CommandPtr showFaceHairCommand(Document& document, bool visible)
{
    return groupsCommand(document, 0,
                         visible ? Commands::tr("Show brows and lashes") : Commands::tr("Hide brows and lashes"),
                         [visible](Project& project) {
                             for (HairGroup& group : project.groups)
                                 if (isFaceHair(group))
                                     group.visible = visible;
                         });
}

CommandPtr removeGroupCommand(Document& document, Id group)
{
    document.endEdit();
    if (document.committed().groups.size() <= 1)
        return nullptr;
    const QString text = Commands::tr("Remove group \"%1\"").arg(nameOf(document, group));
    std::vector<ShownPart> parts{{{.aspect = Change::Aspect::GroupList, .group = group}, [group](Project& project) {
                                      std::erase_if(project.groups,
                                                    [group](const HairGroup& one) { return one.id == group; });
                                  }}};
    // What is worn in its hair goes along.
    if (std::ranges::find(document.committed().worn, group, &Worn::group) != document.committed().worn.end())
        parts.push_back({{.aspect = Change::Aspect::Environment}, [group](Project& project) {
                             std::erase_if(project.worn, [group](const Worn& one) { return one.group == group; });
                         }});
    return shownEditCommand(document, parts, {}, text);
}

CommandPtr renameGroupCommand(Document& document, Id group, const QString& name)
{
    return groupsCommand(document, group, Commands::tr("Rename group \"%1\"").arg(nameOf(document, group)),
                         [group, name](Project& project) {
                             if (HairGroup* one = project.group(group))
                                 one->name = name;
                         });
}

CommandPtr moveGroupCommand(Document& document, Id group, int newPosition)
{
    document.endEdit();
    const std::vector<HairGroup>& groups = document.committed().groups;
    const auto found = std::ranges::find(groups, group, &HairGroup::id);
    const auto from = found - groups.begin();
    const auto to = std::clamp<std::ptrdiff_t>(newPosition, 0, std::ssize(groups) - 1);
    if (found == groups.end() || from == to)
        return nullptr;
    return groupsCommand(document, group, Commands::tr("Move group \"%1\"").arg(nameOf(document, group)),
                         [from, to](Project& project) {
                             const auto first = project.groups.begin();
                             if (from < to)
                                 std::rotate(first + from, first + from + 1, first + to + 1);
                             else
                                 std::rotate(first + to, first + from, first + from + 1);
                         });
}

CommandPtr showGroupCommand(Document& document, Id group, bool visible)
{
    const QString text = visible ? Commands::tr("Show group \"%1\"") : Commands::tr("Hide group \"%1\"");
    return groupsCommand(document, group, text.arg(nameOf(document, group)), [group, visible](Project& project) {
        if (HairGroup* one = project.group(group))
            one->visible = visible;
    });
}

CommandPtr setSettingsCommand(Document& document, Id group, const sim::GroupSettings& settings, const QString& text)
{
    document.endEdit();
    const HairGroup* found = document.committed().group(group);
    if (found == nullptr || found->settings == settings)
        return nullptr;
    return editCommand(document, {.aspect = Change::Aspect::Settings, .group = group}, text,
                       [group, settings](Project& project) {
                           if (HairGroup* one = project.group(group))
                               one->settings = settings;
                       });
}

CommandPtr setRangeCommand(Document& document, RangeChange change, const QString& text)
{
    document.endEdit();
    const HairGroup* found = document.committed().group(change.group);
    if (found == nullptr || found->settings == change.settings)
        return nullptr;
    const Id group = change.group; // Arguments are evaluated in any order.
    return groupsCommand(document, group, text,
                         [change = std::move(change)](Project& project) { change.applyTo(project); });
}

CommandPtr applyPresetCommand(Document& document, const Preset& preset, const StyleUse& use)
{
    return groupsCommand(document, 0, applyPresetText(preset, use.part),
                         [preset, use](Project& project) { applyPreset(project, preset, use); });
}

} // namespace hairpaint::model
