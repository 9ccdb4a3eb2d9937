// What every tool is: plain events on the skin in, a live edit out. Tools never touch widgets.
#pragma once

#include "model/document/document.h"
#include "model/tools/tool_options.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/skin.h"

#include <QCoreApplication>
#include <QKeySequence>
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

/// A place on a drawn hair.
struct GrabbedHair
{
    sim::SurfacePoint root;
    glm::vec3 positionHd{0.0F};
    float alongM = 0.0F; ///< From the root, along the hair; above 0.
};

/// One pointer event, made alike by the paint area and the 3D area.
struct ToolEvent
{
    Area area = Area::Paint;
    /// uv of the pointer; in the paint area possibly off every island or outside 0..1.
    glm::vec2 uv{0.0F};
    /// Where the pointer is on the skin; none off the head.
    std::optional<sim::SurfacePoint> point = {};
    float pressure = 1.0F; ///< 0..1; 1 for a mouse.
    double seconds = 0.0;
    Qt::KeyboardModifiers modifiers = {};
    bool again = false;     ///< The second press of a double click.
    float pixelM = 0.0005F; ///< How large one of the area's pixels is on the skin there.
    /// In the 3D area, for tools that grab: the hair that was pressed on,
    std::optional<GrabbedHair> grabbed = {};
    /// and where the pointer has taken it since, as far from the camera as it was.
    std::optional<glm::vec3> targetHd = {};
};

/// What is drawn over the areas while a tool is in use. uv space; closed where marked.
struct OverlayShape
{
    QPolygonF uvOutline;
    bool closed = true;
    bool marching = false;    ///< A selection: drawn as a moving dashed line.
    QPolygonF uvHandles = {}; ///< Points that can be taken hold of, or taken back: drawn as small squares.
};

enum class ToolId : std::uint8_t
{
    Brush,
    Eraser,
    Comb,
    Part,
    Grab,
    Gradient,
    Fill,
    Shape,
    Select,
    Picker
};
/// "brush": names the icon, and the key in the settings file.
[[nodiscard]] const char* toolName(ToolId id);

class Selection;

/// What tools work with; owned by the app, passed in.
struct ToolContext
{
    Document& document;
    LayerAddress target;    ///< The active layer.
    ToolSettings& settings; ///< Brush size, value, ...; tools may change them (the picker does).
    Selection& selection;
    bool mirror = false;                               ///< Paint the reflected place too.
    std::function<Id(MapKind)> activeLayer = {};       ///< Of the target's group, for each map; 0 where it has none.
    std::shared_ptr<const sim::StrandFrame> hair = {}; ///< The newest that is drawn; null before there is any.

    /// The active layer of another map of the target's group; the top one where nobody says which it is.
    [[nodiscard]] LayerAddress layer(MapKind map) const;
};

/// A small state machine. Painting tools work in an edit session (LiveEdit): one press..release, or one pending shape,
/// is one undo command; cancel() leaves no trace. Somebody else's edit may end the session at any time: active() is
/// false from then on.
class Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    virtual ~Tool() = default;

    [[nodiscard]] virtual ToolId id() const = 0;
    [[nodiscard]] virtual QString title() const = 0;
    [[nodiscard]] virtual QKeySequence defaultKey() const = 0;
    /// What it is for, a sentence.
    [[nodiscard]] virtual QString purpose() const = 0;
    /// What the status bar says the tool does next.
    [[nodiscard]] virtual QString hint() const = 0;
    /// The same of what it does with these settings.
    [[nodiscard]] virtual QString hintFor(const ToolSettings& /*settings*/) const { return hint(); }
    /// What the option bar shows for it.
    [[nodiscard]] virtual ToolOptions options() const = 0;
    [[nodiscard]] virtual bool hasRing() const { return false; } ///< The cursor is a brush ring.
    /// The map that it works on, whichever is active: choosing the tool, or pressing with it, makes that the active
    /// one.
    [[nodiscard]] virtual std::optional<MapKind> map() const { return std::nullopt; }
    /// Ctrl+click takes the value there.
    [[nodiscard]] virtual bool picksWithCtrl(Area /*area*/) const { return hasRing(); }
    /// In the 3D area it takes hold of hair, and of nothing else.
    [[nodiscard]] virtual bool grabs() const { return false; }
    /// Other maps that it changes too, as it is set: a layer of each must be there to be painted on.
    [[nodiscard]] virtual std::vector<MapKind> alsoPaints(const ToolSettings& /*settings*/) const { return {}; }
    /// What a drag with Ctrl paints besides, which else it leaves alone.
    [[nodiscard]] virtual std::optional<MapKind> paintsWithCtrl(Area /*area*/) const { return std::nullopt; }
    [[nodiscard]] virtual bool paints() const { return true; } ///< Needs a layer that can be painted on.

    virtual void press(const ToolEvent& event, ToolContext& context) = 0;
    virtual void move(const ToolEvent& event, ToolContext& context) = 0;
    virtual void release(const ToolEvent& event, ToolContext& context) = 0;
    /// The pointer moves with no button down.
    virtual void hover(const ToolEvent& /*event*/, ToolContext& /*context*/) {}
    /// A key pressed while the tool is in use; false leaves it to others.
    virtual bool key(Qt::Key /*key*/, Qt::KeyboardModifiers /*modifiers*/, ToolContext& /*context*/) { return false; }
    /// What runs is to be as the settings now say.
    virtual void settingsChanged(ToolContext& /*context*/) {}
    virtual void cancel(ToolContext& context) = 0;
    /// Ends a running action early, keeping it.
    virtual void commit(ToolContext& context) = 0;
    /// Something runs: while a button is down, or pending.
    [[nodiscard]] virtual bool active() const = 0;
    /// Something runs that goes on after the button was released: a polygon waits for its next corner.
    [[nodiscard]] virtual bool pending() const { return false; }
    [[nodiscard]] virtual std::vector<OverlayShape> overlay() const { return {}; }
};

/// Every tool, in tool-bar order. A new tool is one file with its class and one line here.
[[nodiscard]] std::vector<std::unique_ptr<Tool>> makeTools();

} // namespace hairpaint::model
