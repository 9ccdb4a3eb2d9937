// What the user is working on and with: shared by every view, changed by every view, outside undo.
#pragma once

#include "model/tools/selection.h"
#include "model/tools/tool.h"
#include "model/tools/value_amounts.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::view {

/// Where the pointer is, as both areas show it.
struct Hover
{
    model::Area area = model::Area::Paint;
    glm::vec2 uv{0.0F};
    std::optional<sim::SurfacePoint> point;
    float pixelM = model::ToolEvent{}.pixelM;
};

/// Lives on the GUI thread. Views read it and call its setters; each setter returns false and tells nothing where
/// nothing differs. Pointer events on the skin go through press/move/release to the active tool, whichever area made
/// them.
class EditorState : public QObject
{
    Q_OBJECT
public:
    explicit EditorState(model::Document& document, QObject* parent = nullptr);
    ~EditorState() override;

    [[nodiscard]] model::Document& document() const { return m_document; }

    [[nodiscard]] model::Id activeGroup() const { return m_activeGroup; }
    bool setActiveGroup(model::Id group);
    [[nodiscard]] model::MapKind activeMap() const { return m_activeMap; }
    bool setActiveMap(model::MapKind map);
    /// The layer that tools paint on in the active map; kept per group and map; 0 where the map has none.
    [[nodiscard]] model::Id activeLayer() const { return activeLayer(m_activeMap); }
    [[nodiscard]] model::Id activeLayer(model::MapKind map) const; ///< The same of any map.
    bool setActiveLayer(model::Id layer);
    [[nodiscard]] model::LayerAddress target() const;
    /// The active group's settings; those of a new group where there is none.
    [[nodiscard]] const sim::GroupSettings& activeSettings() const;

    [[nodiscard]] const std::vector<std::unique_ptr<model::Tool>>& tools() const { return m_tools; }
    [[nodiscard]] model::Tool& activeTool() const { return *m_tools[m_activeTool]; }
    bool setActiveTool(model::ToolId id);
    /// Back to the tool before the last setActiveTool: E toggles brush and eraser.
    void toggleTool(model::ToolId id);

    /// Values of scalar maps keep their amount (15 cm, 3 turns) where another group's or a changed group's range makes
    /// another fraction of it; beyond that range they are at its end until it widens.
    [[nodiscard]] const model::ToolSettings& toolSettings() const { return m_toolSettings; }
    bool setToolSettings(const model::ToolSettings& settings);
    /// Settings and the amounts behind their values, to be put back as they are: also those beyond the group's range.
    struct HeldSettings
    {
        model::ToolSettings settings;
        model::ValueAmounts amounts;
    };
    [[nodiscard]] HeldSettings heldSettings() const { return {m_toolSettings, m_amounts}; }
    void putBack(const HeldSettings& held);
    [[nodiscard]] model::Selection& selection() { return m_selection; }

    [[nodiscard]] bool mirror() const { return m_mirror; }
    bool setMirror(bool mirror);
    [[nodiscard]] bool nightPaper() const { return m_nightPaper; }
    bool setNightPaper(bool night);
    [[nodiscard]] bool wireframe() const { return m_wireframe; }
    bool setWireframe(bool shown);
    /// The outlines of all that is worn, also of what is never drawn.
    [[nodiscard]] bool collidersShown() const { return m_collidersShown; }
    bool setCollidersShown(bool shown);
    /// The worn thing that is edited; 0: none, as while it is not seen.
    [[nodiscard]] model::Id chosenWorn() const;
    bool setChosenWorn(model::Id id);
    /// Short hairs on the head that tell the active direction map, while it is the active one.
    [[nodiscard]] bool directionsShown() const { return m_directionsShown; }
    bool setDirectionsShown(bool shown);

    [[nodiscard]] const std::optional<Hover>& hover() const { return m_hover; }
    /// Where both areas draw the brush's rings: under the pointer, and the mirrored twin if there is one. Empty off the
    /// skin and where the active tool has no ring.
    [[nodiscard]] std::vector<sim::SurfacePoint> ringPoints() const;
    /// What both areas draw over their picture: the active tool's shapes, and the selection's outlines, which march.
    [[nodiscard]] std::vector<model::OverlayShape> overlay() const;
    /// Tools with something pending hear of it too.
    void setHover(const std::optional<Hover>& hover);

    /// The newest hair that is drawn, for tools that ask how it lies.
    void setHair(std::shared_ptr<const sim::StrandFrame> hair) { m_hair = std::move(hair); }

    /// Whether these maps of the active group can be painted on; where not, refused() says why.
    bool mayPaint(std::initializer_list<model::MapKind> maps);
    void tell(const QString& text) { Q_EMIT told(text); }
    /// Pointer events on the skin. press() does nothing where the target layer is missing, hidden or locked: refused()
    /// says why.
    void press(const model::ToolEvent& event);
    void move(const model::ToolEvent& event);
    void release(const model::ToolEvent& event);
    void cancelStroke();
    void commitStroke(); ///< Ends what a tool still has open (a polygon), keeping it.
    [[nodiscard]] bool stroking() const;
    /// A tool that lays hair works at present: what is looked at is the hair.
    [[nodiscard]] bool layingHair() const;
    /// A key pressed over either area: Esc and Enter end what runs, others are the active tool's. False: not ours.
    bool toolKey(Qt::Key key, Qt::KeyboardModifiers modifiers);

Q_SIGNALS:
    void targetChanged(); ///< Active group, map or layer.
    void activeToolChanged();
    void toolSettingsChanged();
    void viewOptionsChanged(); ///< Mirror, night paper, wireframe, directions, colliders and the chosen one.
    void hoverChanged();
    void overlayChanged(); ///< The active tool's overlay or the selection.
    void refused(const QString& reason);
    void told(const QString& text); ///< What the user should know and did not ask for.

private:
    void onDocumentChanged(const model::Change& change);
    [[nodiscard]] model::ToolContext context();
    [[nodiscard]] std::size_t toolIndex(model::ToolId id) const;
    bool setOption(bool& option, bool value);
    [[nodiscard]] const sim::GroupSettings* knownSettings() const; ///< Null where there is no active group.
    /// Puts the amounts on the active group's range.
    void followAmounts(bool tell);
    /// Why the active tool can't start on the target; empty where it can.
    [[nodiscard]] QString refusal(bool picks) const;
    /// Why what Ctrl does besides can't be done.
    [[nodiscard]] QString refusalWithCtrl(const model::ToolEvent& event) const;
    [[nodiscard]] QString refusalOn(const model::HairGroup& group, model::MapKind map) const;
    /// Why it can't change the other maps that it is set to change.
    [[nodiscard]] QString refusalOnOthers() const;
    void takeToolsMap(); ///< Makes the active tool's own map the active one, or what was before it again.
    template<typename Call>
    void withTool(const Call& call);

    model::Document& m_document;
    std::vector<std::unique_ptr<model::Tool>> m_tools;
    std::size_t m_activeTool = 0;
    std::size_t m_previousTool = 0;
    std::optional<model::MapKind> m_mapBeforeTool; ///< Active again when the tool that has a map of its own is left.
    bool m_toolWorks = false;                      ///< A change that is told meanwhile is the active tool's.
    model::LayerAddress m_strokeTarget;            ///< Stays the same from press to release.
    bool m_saidOfCtrl = false;                     ///< In this stroke.
    model::ToolSettings m_toolSettings;
    model::ValueAmounts m_amounts;
    model::Selection m_selection;
    model::Id m_activeGroup = 0;
    model::MapKind m_activeMap = model::MapKind::Length;
    std::vector<model::LayerAddress> m_activeLayers; ///< One for each group and map that was ever active.
    bool m_mirror = true;
    bool m_nightPaper = true;
    bool m_wireframe = true;
    bool m_collidersShown = false;
    model::Id m_chosenWorn = 0;
    bool m_directionsShown = true;
    std::optional<Hover> m_hover;
    std::shared_ptr<const sim::StrandFrame> m_hair;
};

} // namespace hairpaint::view
