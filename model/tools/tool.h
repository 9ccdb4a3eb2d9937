// What every tool is: plain events on the skin in, a live edit out. Tools never touch widgets.
#pragma once

#include "model/document/document.h"
#include "model/tools/demo_strokes.h"
#include "model/tools/tool_id.h"
#include "model/tools/tool_options.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/skin.h"

#include <QCoreApplication>
#include <QKeyCombination>
#include <QPolygonF>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

enum class Area : std::uint8_t
{
    Paint,
    Head
};

/// Where the pointer is over hair of the 3D area's picture.
struct OverHair
{
    QPointF position;           ///< px of the view.
    float pxPerM = 1.0F;        ///< px of the view for a metre at the hair's distance from the camera.
    glm::vec3 positionHd{0.0F}; ///< The pointer's position at the distance of the hair that the stroke began on.
    std::optional<sim::SurfacePoint> root = {}; ///< Root of the strand nearest to the pointer; none between strands.
};

/// One pointer event, made alike by the paint area and the 3D area.
struct ToolEvent
{
    Area area = Area::Paint;
    /// uv of the pointer; in the paint area possibly off every island or outside 0..1.
    glm::vec2 uv{0.0F};
    /// Where the pointer is on the skin; none off the head.
    std::optional<sim::SurfacePoint> point = {};
    /// Set where the tool is to work on the strands that are seen there instead of the skin; `point` is none then.
    std::optional<OverHair> hair = {};
    float pressure = 1.0F; ///< 0..1; 1 for a mouse.
    double seconds = 0.0;
    Qt::KeyboardModifiers modifiers = {};
    bool again = false;     ///< The second press of a double click.
    float pixelM = 0.0005F; ///< How large one of the area's pixels is on the skin there.
};

/// A point of a drawn hair.
struct GrabbedHair
{
    sim::SurfacePoint root;
    glm::vec3 positionHd{0.0F};
    float alongM = 0.0F; ///< Distance from the root along the hair; above 0.
};

/// One pointer event of the 3D area while a hair is held.
struct HairEvent
{
    GrabbedHair hair;         ///< The point of hair that was pressed, the same until the release.
    glm::vec3 targetHd{0.0F}; ///< Where the pointer has moved that point, at its former distance from the camera.
    Qt::KeyboardModifiers modifiers = {};
};

/// One pointer event on the picture of the 3D area, over hair, skin or neither.
struct PictureEvent
{
    QPointF position; ///< px of the view.
    Qt::KeyboardModifiers modifiers = {};
};

/// A line over the picture of the 3D area, px of the view.
struct PictureLine
{
    QPolygonF line = {};
    bool closed = false;
};

/// A hair that can be bent node by node, as it is seen.
struct GuideStrand
{
    sim::SurfacePoint root;
    std::vector<glm::vec3> nodesHd; ///< From the root, which stays, to the tip.
    bool held = false;              ///< Whether one of its nodes is held.
};

/// What is drawn over the areas while a tool is in use. uv space; closed where marked.
struct OverlayShape
{
    QPolygonF uvOutline;
    bool closed = true;
    bool marching = false;    ///< A selection: drawn as a moving dashed line.
    QPolygonF uvHandles = {}; ///< Points that can be taken hold of, or taken back: drawn as small squares.
};

class Selection;
class SeenHair;
struct CutPiece;

/// What tools work with; owned by the app, passed in.
struct ToolContext
{
    Document& document;
    LayerAddress target;    ///< The active layer.
    ToolSettings& settings; ///< Brush size, value, ...; tools may change them (the picker does).
    Selection& selection;
    bool mirror = false; ///< Paint at the reflected point too.
    /// The active layer of each map of the target's group; 0 where it has none.
    std::function<Id(MapKind)> activeLayer = {};
    std::shared_ptr<const sim::StrandFrame> hair = {}; ///< The newest frame that is drawn; null before there is any.
    const SeenHair* seen = nullptr;                    ///< The picture of the 3D area; null outside it.

    /// The active layer of another map of the target's group; the top one where `activeLayer` is not set.
    [[nodiscard]] LayerAddress layer(MapKind map) const;
};

/// The constant properties of a tool: its row.
struct ToolTraits
{
    ToolId id{};
    const char* name = "";    ///< "brush": name of its icon, and part of the names of its keys.
    const char* title = "";   ///< To be translated in context "Tool", as are the next two.
    const char* purpose = ""; ///< What it is for, a sentence.
    const char* hint = "";    ///< What the status bar says it does next, unless the tool itself knows better.
    QKeyCombination key = Qt::Key_unknown;
    ToolOptions options = {}; ///< What the option bar shows for it.
    bool hasRing = false;     ///< The cursor is a brush ring, and Ctrl+click takes the value there.
    bool paints = true;       ///< Needs a layer that can be painted on.
    bool isFirst = false;     ///< The tool that is active at the start; true for one tool.
    bool erases = false;  ///< The eraser, which a pen's other end selects; true for one tool. Its key switches back.
    bool selects = false; ///< It draws the selection; the option bar then shows the selection's actions.
    /// The map that it works on, whichever is active: choosing the tool, or pressing with it, makes that the active
    /// one.
    std::optional<MapKind> map = {};
    /// A map that a drag with Ctrl on the head paints, too.
    std::optional<MapKind> paintsWithCtrl = {};
    /// Another map that it also changes with these settings, which needs a layer that can be painted on. Null: never
    /// any.
    std::optional<MapKind> (*alsoPaints)(const ToolSettings& settings) = nullptr;
    const DemoStroke* demo = nullptr; ///< Its demonstration; null where none is needed.
    /// Whether it works on strands, too, where they are seen in the 3D area. Null: never.
    bool (*worksOnHair)(const ToolSettings& settings) = nullptr;
};

/// The interface of tools that work on the skin, in both areas.
class SkinHandler
{
public:
    virtual ~SkinHandler() = default;
    virtual void press(const ToolEvent& event, ToolContext& context) = 0;
    virtual void move(const ToolEvent& event, ToolContext& context) = 0;
    virtual void release(const ToolEvent& event, ToolContext& context) = 0;
    /// The pointer moves with no button down.
    virtual void hover(const ToolEvent& /*event*/, ToolContext& /*context*/) {}
};

/// The interface of tools that grab hair in the 3D area, and nothing else.
class HairHandler
{
public:
    virtual ~HairHandler() = default;
    virtual void pressHair(const HairEvent& event, ToolContext& context) = 0;
    virtual void moveHair(const HairEvent& event, ToolContext& context) = 0;
    virtual void releaseHair(const HairEvent& event, ToolContext& context) = 0;
    /// The pointer moves over hair, or beside it, with no button down.
    virtual void hoverHair(const std::optional<GrabbedHair>& /*hair*/, ToolContext& /*context*/) {}
    /// Hairs that it offers, to be bent by their nodes.
    [[nodiscard]] virtual std::vector<GuideStrand> guides() const = 0;
};

/// The interface of tools that draw over the picture of the 3D area, wherever they begin. It is one of its own, since
/// its events have neither a point of the skin nor a hair, and go on while nothing is under the pointer.
class PictureHandler
{
public:
    virtual ~PictureHandler() = default;
    virtual void pressPicture(const PictureEvent& event, ToolContext& context) = 0;
    virtual void movePicture(const PictureEvent& event, ToolContext& context) = 0;
    virtual void releasePicture(const PictureEvent& event, ToolContext& context) = 0;
    /// What it has drawn.
    [[nodiscard]] virtual PictureLine pictureLine() const = 0;
    /// What the last action has cut off; given once.
    [[nodiscard]] virtual std::vector<CutPiece> takeCutOff() = 0;
};

/// A small state machine. Painting tools work in an edit session (LiveEdit): one press..release, or one pending shape,
/// is one undo command; cancel() leaves no trace. Somebody else's edit may end the session at any time: active() is
/// false from then on.
class Tool : public SkinHandler
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] virtual const ToolTraits& traits() const = 0;
    [[nodiscard]] ToolId id() const { return traits().id; }
    [[nodiscard]] const char* name() const { return traits().name; }
    [[nodiscard]] QString title() const { return tr(traits().title); }
    [[nodiscard]] QString purpose() const { return tr(traits().purpose); }
    [[nodiscard]] ToolOptions options() const { return traits().options; }
    [[nodiscard]] std::optional<MapKind> map() const { return traits().map; }
    [[nodiscard]] std::optional<MapKind> paintsWithCtrl(Area area) const
    {
        return area == Area::Head ? traits().paintsWithCtrl : std::nullopt;
    }
    [[nodiscard]] bool picksWithCtrl(Area area) const { return traits().hasRing && !paintsWithCtrl(area); }
    [[nodiscard]] std::optional<MapKind> alsoPaints(const ToolSettings& settings) const
    {
        return traits().alsoPaints != nullptr ? traits().alsoPaints(settings) : std::nullopt;
    }

    /// What the status bar says the tool does next.
    [[nodiscard]] virtual QString hint() const { return tr(traits().hint); }
    /// The same with these settings: the hint of the choice that is set, or hint() where it has none.
    [[nodiscard]] QString hintFor(const ToolSettings& settings) const;
    /// Text of the undo step with these settings; empty where no choice has one, and the title is used.
    [[nodiscard]] QString stepFor(const ToolSettings& settings) const;

    /// What takes hold of hair in the 3D area; null where the tool works on the skin there, too.
    [[nodiscard]] virtual HairHandler* hairHandler() { return nullptr; }
    /// What draws over the 3D area's picture; null where the tool works on the skin there, or on hair.
    [[nodiscard]] virtual PictureHandler* pictureHandler() { return nullptr; }
    /// A key pressed while the tool is in use; false leaves it to others.
    virtual bool key(Qt::Key /*key*/, Qt::KeyboardModifiers /*modifiers*/, ToolContext& /*context*/) { return false; }
    /// The settings have changed: brings the running action up to date with them.
    virtual void settingsChanged(ToolContext& /*context*/) {}
    virtual void cancel(ToolContext& context) = 0;
    /// Ends a running action early, keeping it.
    virtual void commit(ToolContext& context) = 0;
    /// Whether an action runs: while a button is down, or pending.
    [[nodiscard]] virtual bool active() const = 0;
    /// Whether the action goes on after the button was released: a polygon waits for its next corner.
    [[nodiscard]] virtual bool pending() const { return false; }
    [[nodiscard]] virtual std::vector<OverlayShape> overlay() const { return {}; }
};

} // namespace hairpaint::model
