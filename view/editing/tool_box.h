// The active tool, its settings and its stroke.
#pragma once

#include "model/tools/cutting/cut_pieces.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/tool.h"
#include "model/tools/value_amounts.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::view {

class EditTarget;
class ViewOptions;

/// Not undone. Each setter returns false and emits nothing if nothing differs. Pointer events of either area go
/// through press, move and release to the active tool. GUI thread; what it is made of must outlive it.
class ToolBox : public QObject
{
    Q_OBJECT
public:
    ToolBox(EditTarget& target, const ViewOptions& options, QObject* parent = nullptr);
    ~ToolBox() override;

    [[nodiscard]] const std::vector<std::unique_ptr<model::Tool>>& all() const { return m_tools; }
    [[nodiscard]] model::Tool& active() const { return *m_tools[m_active]; }
    bool choose(model::ToolId id);
    /// The one that has that trait: isFirst, erases.
    [[nodiscard]] model::ToolId with(bool model::ToolTraits::*trait) const;
    /// Back to the tool before the last choose: E toggles brush and eraser.
    void toggle(model::ToolId id);

    /// Values of scalar maps keep their amount (15 cm, 3 turns) where another group's or a changed group's range makes
    /// another fraction of it; beyond that range they are at its end until it widens.
    [[nodiscard]] const model::ToolSettings& settings() const { return m_settings; }
    bool setSettings(const model::ToolSettings& settings);
    /// What a window begins with, for the active group.
    [[nodiscard]] model::ToolSettings startSettings() const;
    /// Settings and the amounts behind their values, to be put back as they are: also those beyond the group's range.
    struct HeldSettings
    {
        model::ToolSettings settings;
        model::ValueAmounts amounts;
    };
    [[nodiscard]] HeldSettings heldSettings() const { return {m_settings, m_amounts}; }
    void putBack(const HeldSettings& held);
    [[nodiscard]] model::Selection& selection() { return m_selection; }

    /// The newest hair that is drawn, for tools that ask how it lies.
    void setHair(std::shared_ptr<const sim::StrandFrame> hair) { m_hair = std::move(hair); }
    /// The 3D area's picture; null: there is none. Must outlive this, or be taken back.
    void setSeen(const model::SeenHair* seen) { m_seen = seen; }

    /// Whether these maps of the active group can be painted on; where not, refused() says why.
    bool mayPaint(std::initializer_list<model::MapKind> maps);
    /// Pointer events on the skin. press() does nothing where the target layer is missing, hidden or locked: refused()
    /// says why.
    void press(const model::ToolEvent& event);
    void move(const model::ToolEvent& event);
    void release(const model::ToolEvent& event);
    /// The same with hair in the hand, where the active tool takes hold of it.
    void press(const model::HairEvent& event);
    void move(const model::HairEvent& event);
    void release(const model::HairEvent& event);
    /// The pointer moves over hair, or beside it, with no button down.
    void hover(const std::optional<model::GrabbedHair>& hair);
    /// The same over the 3D area's picture, where the active tool draws over it.
    void press(const model::PictureEvent& event);
    void move(const model::PictureEvent& event);
    void release(const model::PictureEvent& event);
    /// The pointer moves with no button down; none: it left.
    void hover(const std::optional<model::ToolEvent>& event);
    /// A key pressed over either area: Esc and Enter end what runs, others are the active tool's. False: not ours.
    bool key(Qt::Key key, Qt::KeyboardModifiers modifiers);
    void cancelStroke();
    void commitStroke(); ///< Ends what a tool still has open (a polygon), keeping it.
    [[nodiscard]] bool stroking() const { return active().active(); }
    /// A tool that lays hair works at present: what is looked at is the hair.
    [[nodiscard]] bool layingHair() const;
    /// What both areas draw over their picture: the active tool's shapes, and the selection's outlines, which march.
    [[nodiscard]] std::vector<model::OverlayShape> overlay() const;
    /// What the active tool has drawn over the 3D area's picture, and the hairs that it offers there to be bent.
    [[nodiscard]] model::PictureLine pictureLine() const;
    [[nodiscard]] std::vector<model::GuideStrand> guides() const;

Q_SIGNALS:
    void activeChanged();
    void settingsChanged();
    void hairCutOff(const std::vector<hairpaint::model::CutPiece>& pieces);
    void overlayChanged(); ///< The active tool's overlay or the selection.
    void refused(const QString& reason);
    void told(const QString& text); ///< A message that the user did not ask for.

private:
    [[nodiscard]] model::ToolContext context();
    [[nodiscard]] std::size_t index(model::ToolId id) const;
    /// Converts the amounts to fractions of the active group's range.
    void followAmounts(bool tell);
    /// Returns false, with a message, if the active tool cannot start on the target.
    bool mayStart(model::Area area, Qt::KeyboardModifiers modifiers);
    void tellOfCtrl(model::Area area, Qt::KeyboardModifiers modifiers);
    /// Why what Ctrl does besides can't be done.
    [[nodiscard]] QString refusalWithCtrl(model::Area area, Qt::KeyboardModifiers modifiers) const;
    /// Why it can't change the other map that it is set to change.
    [[nodiscard]] QString refusalOnOthers() const;
    void takeToolsMap(); ///< Makes the active tool's own map the active one, or what was before it again.
    template<typename Call>
    void withTool(const Call& call);

    EditTarget& m_target;
    const ViewOptions& m_options;
    std::vector<std::unique_ptr<model::Tool>> m_tools;
    std::size_t m_active = 0;
    std::size_t m_previous = 0;
    std::optional<model::MapKind> m_mapBeforeTool; ///< Active again when the tool that has a map of its own is left.
    model::LayerAddress m_strokeTarget;            ///< Stays the same from press to release.
    bool m_saidOfCtrl = false;                     ///< In this stroke.
    model::ToolSettings m_settings;
    model::ValueAmounts m_amounts;
    model::Selection m_selection;
    std::shared_ptr<const sim::StrandFrame> m_hair;
    const model::SeenHair* m_seen = nullptr;
};

} // namespace hairpaint::view
