// Parts of the content taken out and put back.
#include "model/document/edit_command.h"

#include "model/document/paint_command.h"
#include "model/document/undo_budget.h"
#include "model/project/worn_on_ties.h"

#include <algorithm>
#include <optional>
#include <variant>

namespace hairpaint::model {

namespace {

struct GroupsPart
{
    std::vector<HairGroup> groups;
    std::vector<Worn> worn; ///< In their hair; a style brings its own.
    Id nextId = 1;

    static GroupsPart take(const Project& project, const Change& /*change*/)
    {
        return {project.groups, project.worn, project.nextId};
    }
    void put(Project& project, const Change& /*change*/) const
    {
        project.groups = groups;
        project.worn = worn;
        project.nextId = nextId;
    }
    friend bool operator==(const GroupsPart&, const GroupsPart&) = default;
};

/// One map.
struct StackPart
{
    std::optional<SharedStack> stack;
    Id nextId = 1;

    static StackPart take(const Project& project, const Change& change)
    {
        const HairGroup* group = project.group(change.group);
        if (group == nullptr)
            return {std::nullopt, project.nextId};
        return {group->maps[static_cast<std::size_t>(change.map)], project.nextId};
    }
    void put(Project& project, const Change& change) const
    {
        if (HairGroup* group = project.group(change.group); group != nullptr && stack)
            group->maps[static_cast<std::size_t>(change.map)] = *stack;
        project.nextId = nextId;
    }
    friend bool operator==(const StackPart&, const StackPart&) = default;
};

struct SettingsPart
{
    sim::GroupSettings settings;

    static SettingsPart take(const Project& project, const Change& change)
    {
        const HairGroup* group = project.group(change.group);
        return {group != nullptr ? group->settings : sim::GroupSettings{}};
    }
    void put(Project& project, const Change& change) const
    {
        if (HairGroup* group = project.group(change.group))
            group->settings = settings;
    }
    friend bool operator==(const SettingsPart&, const SettingsPart&) = default;
};

struct EnvironmentPart
{
    sim::Wind wind;
    LightSettings light;
    QRgb background = 0;
    SkinTone skin = SkinTone::Clay;
    std::vector<Worn> worn;
    Id nextId = 1;

    static EnvironmentPart take(const Project& project, const Change& /*change*/)
    {
        EnvironmentPart part{project.wind, project.light, project.background,
                             project.skin, project.worn,  project.nextId};
        part.wind.enabled = true; // Whether it blows is no part of the history: Document::setWindOn.
        return part;
    }
    void put(Project& project, const Change& /*change*/) const
    {
        project.wind = blowingAs(project.wind, wind);
        project.light = light;
        project.background = background;
        project.skin = skin;
        project.worn = worn;
        project.nextId = nextId;
    }
    friend bool operator==(const EnvironmentPart&, const EnvironmentPart&) = default;
};

struct HeadSwapPart
{
    std::shared_ptr<const Head> head;
    SkinTone skin = SkinTone::Clay;
    std::vector<Worn> worn;
    Id nextId = 1;

    static HeadSwapPart take(const Project& project, const Change& /*change*/)
    {
        return {project.head, project.skin, project.worn, project.nextId};
    }
    void put(Project& project, const Change& /*change*/) const
    {
        project.head = head;
        project.skin = skin;
        project.worn = worn;
        project.nextId = nextId;
    }
    friend bool operator==(const HeadSwapPart& a, const HeadSwapPart& b) { return a.head == b.head; }
};

using Part = std::variant<GroupsPart, StackPart, SettingsPart, EnvironmentPart, HeadSwapPart>;

Part partOf(const Project& project, const Change& change)
{
    switch (change.aspect) {
    case Change::Aspect::LayerList:
        return StackPart::take(project, change);
    case Change::Aspect::Settings:
        return SettingsPart::take(project, change);
    case Change::Aspect::Environment:
        return EnvironmentPart::take(project, change);
    case Change::Aspect::Head:
        return HeadSwapPart::take(project, change);
    default:
        return GroupsPart::take(project, change);
    }
}

/// Bytes of the tiles that a map had and has no more; every layer of it where it is gone.
std::size_t bytesLost(const SharedStack& before, const SharedStack* after)
{
    if (after != nullptr && before.sharesWith(*after))
        return 0;
    std::size_t bytes = 0;
    for (const Layer& layer : before->layers) {
        const Layer* kept = nullptr;
        if (after != nullptr) {
            const auto found = std::ranges::find((*after)->layers, layer.id, &Layer::id);
            if (found != (*after)->layers.end() && found->raster.size() == layer.raster.size())
                kept = &*found;
        }
        for (int index = 0; index < layer.raster.tileCount(); ++index)
            if (kept == nullptr || kept->raster.tile(index) != layer.raster.tile(index))
                bytes += bytesOf(layer.raster.tile(index));
    }
    return bytes;
}

std::size_t bytesLost(const GroupsPart& before, const GroupsPart& after)
{
    std::size_t bytes = 0;
    for (const HairGroup& group : before.groups) {
        const auto kept = std::ranges::find(after.groups, group.id, &HairGroup::id);
        for (std::size_t map = 0; map < group.maps.size(); ++map)
            bytes += bytesLost(group.maps[map], kept != after.groups.end() ? &kept->maps[map] : nullptr);
    }
    return bytes;
}

class EditCommand : public QUndoCommand, public TileHolder
{
public:
    EditCommand(Document& document, Change change, const QString& text, std::function<void(Project&)> edit)
        : QUndoCommand(text), m_document(document), m_change(std::move(change)), m_edit(std::move(edit))
    {}

    void redo() override
    {
        m_document.apply(m_change, [this](Project& project) {
            if (m_edit == nullptr) {
                put(m_after, project);
                return;
            }
            m_before = partOf(project, m_change);
            runFollowingTies(project, m_edit);
            m_edit = nullptr;
            m_after = partOf(project, m_change);
        });
    }
    void undo() override
    {
        m_document.apply(m_change, [this](Project& project) { put(m_before, project); });
    }

    [[nodiscard]] std::size_t keptBytes() const override
    {
        if (!m_before || !m_after)
            return 0;
        if (const auto* groups = std::get_if<GroupsPart>(&*m_before))
            return bytesLost(*groups, std::get<GroupsPart>(*m_after));
        if (const auto* map = std::get_if<StackPart>(&*m_before); map != nullptr && map->stack) {
            const std::optional<SharedStack>& after = std::get<StackPart>(*m_after).stack;
            return bytesLost(*map->stack, after ? &*after : nullptr);
        }
        return 0;
    }
    void release() override
    {
        m_before.reset();
        m_after.reset();
    }

private:
    void put(const std::optional<Part>& part, Project& project) const
    {
        std::visit([&](const auto& one) { one.put(project, m_change); }, part.value());
    }

    Document& m_document;
    Change m_change;
    std::function<void(Project&)> m_edit; ///< Until it ran.
    std::optional<Part> m_before, m_after;
};

/// Several commands as one step.
class JoinedCommand : public QUndoCommand, public TileHolder
{
public:
    JoinedCommand(std::vector<CommandPtr> commands, const QString& text)
        : QUndoCommand(text), m_commands(std::move(commands))
    {}
    void redo() override
    {
        for (const CommandPtr& command : m_commands)
            command->redo();
    }
    void undo() override
    {
        for (std::size_t i = m_commands.size(); i-- > 0;)
            m_commands[i]->undo();
    }
    [[nodiscard]] std::size_t keptBytes() const override
    {
        std::size_t bytes = 0;
        for (const CommandPtr& command : m_commands)
            bytes += dynamic_cast<const TileHolder&>(*command).keptBytes();
        return bytes;
    }
    void release() override
    {
        for (const CommandPtr& command : m_commands)
            dynamic_cast<TileHolder&>(*command).release();
    }

private:
    std::vector<CommandPtr> m_commands;
};

/// Whether the edit, run on the committed content, changes the part it may touch.
bool changesContent(const Project& committed, const ShownPart& part)
{
    Project edited = committed;
    runFollowingTies(edited, part.edit);
    return partOf(edited, part.change) != partOf(committed, part.change);
}

} // namespace

namespace {

/// Leaves the patches of accessory maps to others.
CommandPtr plainEditCommand(Document& document, const Change& change, const QString& text,
                            std::function<void(Project&)> edit)
{
    document.endEdit();
    if (change.aspect == Change::Aspect::LayerList || change.aspect == Change::Aspect::GroupList) {
        Project after = document.committed();
        edit(after);
        if (!document.mayBecome(after))
            return nullptr;
    }
    return std::make_unique<EditCommand>(document, change, text, std::move(edit));
}

} // namespace

bool needsPatches(const Change& change)
{
    using Aspect = Change::Aspect;
    const bool isOneMap = change.aspect == Aspect::Texels || change.aspect == Aspect::LayerList;
    return isOneMap ? change.map == MapKind::Accessory
                    : change.aspect == Aspect::GroupList || change.aspect == Aspect::Head;
}

CommandPtr withPatches(Document& document, CommandPtr command, Project after, const QString& text)
{
    if (command == nullptr)
        return nullptr;
    ProjectPatches patches = document.patches();
    if (!patches.follow(after, &document.patches()))
        return command;
    std::vector<CommandPtr> commands;
    commands.push_back(std::move(command));
    commands.push_back(
        std::make_unique<EditCommand>(document, Change{.aspect = Change::Aspect::Environment}, text,
                                      [worn = std::move(after.worn), nextId = after.nextId](Project& project) {
                                          project.worn = worn;
                                          project.nextId = nextId;
                                      }));
    return std::make_unique<JoinedCommand>(std::move(commands), text);
}

CommandPtr editCommand(Document& document, const Change& change, const QString& text,
                       std::function<void(Project&)> edit)
{
    if (!needsPatches(change))
        return plainEditCommand(document, change, text, std::move(edit));
    CommandPtr command = plainEditCommand(document, change, text, edit);
    if (command == nullptr)
        return nullptr;
    Project after = document.committed();
    runFollowingTies(after, edit);
    return withPatches(document, std::move(command), std::move(after), text);
}

CommandPtr shownEditCommand(Document& document, const std::vector<ShownPart>& parts, std::vector<LayerEdit> layers,
                            const QString& text)
{
    std::vector<CommandPtr> commands;
    bool touchesPatches = false;
    for (const ShownPart& part : parts) {
        if (!changesContent(document.committed(), part))
            continue;
        CommandPtr command = plainEditCommand(document, part.change, text, part.edit);
        if (command == nullptr)
            return nullptr; // Refused: all of it or nothing.
        commands.push_back(std::move(command));
        touchesPatches |= needsPatches(part.change);
    }
    for (const LayerEdit& layer : layers)
        touchesPatches |= layer.address.map == MapKind::Accessory;
    Project after;
    if (touchesPatches) {
        after = document.committed();
        for (const ShownPart& part : parts)
            runFollowingTies(after, part.edit);
        layIn(after, layers);
    }
    if (CommandPtr paint = plainPaintCommand(document, std::move(layers), text))
        commands.push_back(std::move(paint));
    if (commands.empty())
        return nullptr;
    CommandPtr whole =
        commands.size() == 1 ? std::move(commands.front()) : std::make_unique<JoinedCommand>(std::move(commands), text);
    return touchesPatches ? withPatches(document, std::move(whole), std::move(after), text) : std::move(whole);
}

} // namespace hairpaint::model
