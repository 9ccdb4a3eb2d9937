// Grab: hair that is taken hold of goes where the pointer goes.
#include "model/maps/compositor.h"
#include "model/tools/live_edit.h"
#include "model/tools/lying/comb_field.h"
#include "model/tools/lying/fallen_hair.h"
#include "model/tools/picker_tool.h"
#include "model/tools/shaping/bent_hair.h"
#include "model/tools/shaping/guide_strands.h"
#include "model/tools/strokes/dab_shape.h"
#include "model/tools/strokes/skin_frames.h"
#include "model/tools/tool_list.h"
#include "model/values/texel_math.h"
#include "sim/groom/direction_texel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr std::array kGrabKinds{
    ToolChoice::Item{.icon = "grab-hair", .title = QT_TRANSLATE_NOOP("ToolOptions", "Grab hair wherever it is seen")},
    ToolChoice::Item{.icon = "grab-guides",
                     .title =
                         QT_TRANSLATE_NOOP("ToolOptions", "Bend single hairs by their nodes; the hair around follows"),
                     .hint = QT_TRANSLATE_NOOP(
                         "Tool", "Point at hair, and drag a node of the hairs that are shown; they keep their length")},
};
constexpr ToolOption kGrabKind{
    .key = "grab",
    .kind =
        ToolChoice{.entries = kGrabKinds,
                   .read = [](const ToolSettings& settings) { return static_cast<int>(settings.grab); },
                   .write = [](ToolSettings& settings, int index) { settings.grab = static_cast<GrabKind>(index); }}};
constexpr ToolOption kGrabGel{
    .key = "grab_gel",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Gel at least"),
    .hint =
        QT_TRANSLATE_NOOP("ToolOptions", "The gel that keeps hair where it was pulled; long hair falls back without"),
    .kind = ToolNumber{.field = &ToolSettings::grabGel, .standard = 30.0}};
constexpr std::array kGrabOptions{&kGrabKind, &kSizeOption, &kHardnessOption, &kOpacityOption, &kGrabGel};

constexpr float kStillM = 0.001F; ///< A pointer that moved less has not moved.
constexpr float kAlike = 0.5F;    ///< Cosine to the held hair's direction from which hair goes along fully,
constexpr float kHangs = 2.0F;    ///< Hair longer than this many times its standing length hangs.
constexpr float kUnlike = 0.1F;   ///< and below which hair stays.
const glm::vec3 kOverTheMiddle(-1.0F, 1.0F, 1.0F); ///< Reflects Hd.

/// One point of the skin whose hair is pulled along, and the direction that it gets.
struct Held
{
    sim::SurfacePoint root;
    /// Factors of Hd that turn the pointer's movement into this point's: its mirror image or itself.
    glm::vec3 across{1.0F};
    glm::vec3 lyingHd{0.0F};           ///< Unit direction in which hair lay there when it was grabbed.
    std::vector<float> agreement = {}; ///< [kSize][kSize] of SkinFrames; below 0: not asked for yet.
};

constexpr ToolTraits kGrab{
    .id = ToolId::Grab,
    .name = "grab",
    .title = QT_TRANSLATE_NOOP("Tool", "Grab"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Takes hold of hair where it is seen and lays it where it is let go."),
    .hint = QT_TRANSLATE_NOOP(
        "Tool", "Press on hair and drag it where it should go; with Ctrl it grows or shrinks to the pointer"),
    .key = Qt::Key_Y,
    .options = kGrabOptions,
    .hasRing = true,
    .map = MapKind::Direction,
    .paintsWithCtrl = MapKind::Length,
    .alsoPaints =
        [](const ToolSettings& settings) {
            return settings.grabGel > 0.0F ? std::optional(MapKind::Gel) : std::nullopt;
        },
    .demo = &kGrabDemo};

class GrabTool : public Tool, private HairHandler
{
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kGrab; }

    [[nodiscard]] HairHandler* hairHandler() override { return this; }

    void press(const ToolEvent& event, ToolContext& context) override;
    void move(const ToolEvent& event, ToolContext& context) override
    {
        if (event.point)
            pull(event.point->positionHd, false, context);
    }
    void release(const ToolEvent& event, ToolContext& context) override
    {
        if (!active())
            return;
        move(event, context);
        commit(context);
    }
    void cancel(ToolContext& /*context*/) override
    {
        m_edit.cancel();
        drop();
    }
    void commit(ToolContext& /*context*/) override
    {
        m_edit.commit();
        drop();
    }
    [[nodiscard]] bool active() const override { return m_edit.active(); }

private:
    void pressHair(const HairEvent& event, ToolContext& context) override { take(event.hair, context); }
    void moveHair(const HairEvent& event, ToolContext& context) override
    {
        pull(event.targetHd, event.modifiers.testFlag(Qt::ControlModifier), context);
    }
    void hoverHair(const std::optional<GrabbedHair>& hair, ToolContext& context) override
    {
        if (active())
            return;
        m_guides = hair && context.settings.grab == GrabKind::Guides ? guidesAround(context, hair->root)
                                                                     : std::vector<GuideStrand>();
    }
    void releaseHair(const HairEvent& event, ToolContext& context) override
    {
        if (!active())
            return;
        moveHair(event, context);
        commit(context);
    }
    [[nodiscard]] std::vector<GuideStrand> guides() const override { return m_guides; }

    /// `hair`: on the skin itself, 0 along, in the paint area.
    void take(const GrabbedHair& hair, ToolContext& context);
    void pull(glm::vec3 targetHd, bool lengths, ToolContext& context);
    [[nodiscard]] StrokeBuffer masksFor(std::size_t layer, const ToolSettings& settings);
    [[nodiscard]] glm::vec3 lyingHd(glm::vec2 uv, const sim::SkinFrame& frame);
    [[nodiscard]] float agreement(Held& held, glm::vec2 position);
    void layGel(const ToolSettings& settings);
    void layDirections(glm::vec3 directionHd, std::optional<float> flatness, const ToolSettings& settings);
    void takeCourse(const GrabbedHair& hair, const ToolContext& context);
    void layCourse(glm::vec3 targetHd, const ToolSettings& settings);
    void layLengths(float factor, const sim::GroupSettings& group, const ToolSettings& settings);
    void drop();

    LiveEdit m_edit;                     ///< Edits the direction layer, then the length and the gel layer.
    std::optional<std::size_t> m_length; ///< Index of the length layer in m_edit; none where it can't be painted on.
    std::optional<std::size_t> m_gel;    ///< Index of the gel layer in m_edit, likewise.
    std::shared_ptr<const sim::TiledRaster> m_lengthBefore; ///< The resolved length map before the drag.
    std::vector<Held> m_held;
    std::shared_ptr<const sim::TiledRaster> m_gelBefore; ///< The resolved gel map before the drag.
    std::optional<StrokeBuffer> m_masks, m_lengthMasks, m_gelMasks;
    std::vector<int> m_tiles, m_lengthTiles, m_gelTiles; ///< Tiles that the masks of each map touch.
    std::unique_ptr<SkinFrames> m_frames;                ///< Kept from drag to drag.
    std::optional<FallenHair> m_before;                  ///< How hair lay when the drag began.
    glm::vec3 m_startHd{0.0F};
    float m_alongM = 0.0F; ///< Distance of the grabbed point from the root along the hair; 0 in the paint area.
    bool m_moved = false;
    std::vector<GuideStrand> m_guides; ///< Guide hairs that can be bent.
    HairCourse m_course;          ///< Course of the bent hair before the drag; empty where only its root is turned.
    std::size_t m_courseNode = 0; ///< Index of the held node of the course.
};

void GrabTool::press(const ToolEvent& event, ToolContext& context)
{
    if (picksWithCtrl(event.area) && picksInstead(event, context))
        return;
    if (event.area == Area::Paint && event.point)
        take({.root = *event.point, .positionHd = event.point->positionHd}, context);
}

void GrabTool::take(const GrabbedHair& hair, ToolContext& context)
{
    const Head* head = context.document.project().head.get();
    if (active() || context.target.map != MapKind::Direction || head == nullptr || head->skin == nullptr)
        return;
    const bool inTheAir = hair.alongM > 0.0F;
    std::shared_ptr<const sim::TiledRaster> length =
        context.document.resolvedNow(context.target.group, MapKind::Length);
    std::shared_ptr<const sim::TiledRaster> gel = context.document.resolvedNow(context.target.group, MapKind::Gel);
    if (!m_edit.begin(context, title()))
        return;
    m_edit.setText(title());
    const sim::SurfacePoint& root = hair.root;
    m_startHd = hair.positionHd;
    m_alongM = hair.alongM;
    m_moved = false;
    m_held = {{.root = root}};
    if (context.mirror)
        if (const auto other = head->skin->mirrored(root);
            other && glm::distance(other->positionHd, root.positionHd) > 0.5F * context.settings.brushSizeM)
            m_held.push_back({.root = *other, .across = kOverTheMiddle});
    if (m_frames == nullptr || !m_frames->isOf(head->skin))
        m_frames = std::make_unique<SkinFrames>(head->skin);
    m_before.emplace(context, *m_frames, m_edit.size());
    for (Held& held : m_held)
        held.lyingHd = lyingHd(held.root.uv, sim::SkinFrame::at(held.root));
    takeCourse(hair, context);
    m_masks.emplace(masksFor(0, context.settings));
    m_tiles = m_masks->takeDirty();
    m_length = inTheAir ? m_edit.also(context, context.layer(MapKind::Length)) : std::nullopt;
    if (m_length) {
        m_lengthBefore = std::move(length);
        m_lengthMasks.emplace(masksFor(*m_length, context.settings));
        m_lengthTiles = m_lengthMasks->takeDirty();
    }
    m_gel =
        inTheAir && context.settings.grabGel > 0.0F ? m_edit.also(context, context.layer(MapKind::Gel)) : std::nullopt;
    if (m_gel) {
        m_gelBefore = std::move(gel);
        m_gelMasks.emplace(masksFor(*m_gel, context.settings));
        m_gelTiles = m_gelMasks->takeDirty();
    }
}

void GrabTool::pull(glm::vec3 targetHd, bool lengths, ToolContext& context)
{
    if (!active())
        return;
    m_moved = m_moved || glm::distance(targetHd, m_startHd) > kStillM;
    const HairGroup* group = context.document.project().group(context.target.group);
    if (!m_moved || group == nullptr)
        return;
    const glm::vec3 rootHd = m_held.front().root.positionHd;
    // Only so much of a hair shows where it goes at its root; the rest hangs, wherever that points.
    const float carried = std::min(1.0F, group->settings.physics.stiffnessM / std::max(m_alongM, kStillM));
    const glm::vec3 offset = targetHd - m_startHd + (m_startHd - rootHd) * (m_alongM > 0.0F ? carried : 1.0F);
    const float distanceM = glm::distance(targetHd, rootHd);
    if (glm::length(offset) < kStillM || distanceM < kStillM)
        return;
    const ToolSettings& settings = context.settings;
    const bool inTheAir = m_alongM > 0.0F;
    if (!m_course.empty())
        layCourse(targetHd, settings);
    else
        layDirections(glm::normalize(offset), inTheAir ? std::nullopt : std::optional(settings.flatness), settings);
    if (active() && m_gel)
        layGel(settings);
    if (!active() || !m_length)
        return;
    if (lengths && inTheAir)
        layLengths(distanceM / m_alongM, group->settings, settings);
    else
        m_edit.replace({}, {}, *m_length);
}

/// Around what is held, by the brush: hair that lies in the same direction.
StrokeBuffer GrabTool::masksFor(std::size_t layer, const ToolSettings& settings)
{
    const int size = m_edit.size(layer);
    StrokeBuffer masks(size);
    for (Held& held : m_held) {
        Dab dab = dabAt(SkinMetric::at(held.root), held.root.uv, 0.5F * settings.brushSizeM, size);
        dab.hardness = settings.hardness;
        StrokeBuffer own(size);
        for (const sim::TexelRect& clip : m_edit.clips(layer))
            own.add(dab, clip);
        for (const int tile : own.takeDirty()) {
            const StrokeBuffer::MaskTile& from = *own.mask(tile);
            StrokeBuffer::MaskTile& to = masks.writableMask(tile);
            const sim::TexelRect rect = m_edit.before(layer).tileRect(tile);
            std::size_t texel = 0;
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                    if (from[texel] == 0)
                        continue;
                    const glm::vec2 position = (glm::vec2(x, y) + 0.5F) / static_cast<float>(size);
                    const float along = agreement(held, position) * static_cast<float>(from[texel]);
                    to[texel] = std::max(to[texel], static_cast<std::uint16_t>(along));
                }
        }
    }
    return masks;
}

/// Unit: how hair grows there, or where it is long, to which side it falls.
glm::vec3 GrabTool::lyingHd(glm::vec2 uv, const sim::SkinFrame& frame)
{
    const glm::vec2 inPlane = m_before->at(uv);
    const float up = std::sqrt(std::max(0.0F, 1.0F - glm::dot(inPlane, inPlane)));
    return frame.toHd(inPlane) + frame.normal * up;
}

/// 1 where hair lies as that which is held, 0 where it lies elsewhere, as beyond a parting. Found once for each sample
/// of the frames' table. `position`: from the layout's upper left.
float GrabTool::agreement(Held& held, glm::vec2 position)
{
    const glm::ivec2 cell = glm::clamp(glm::ivec2(position * static_cast<float>(SkinFrames::kSize)), glm::ivec2(0),
                                       glm::ivec2(SkinFrames::kSize - 1));
    if (held.agreement.empty())
        held.agreement.resize(std::size_t{SkinFrames::kSize} * SkinFrames::kSize, -1.0F);
    float& known =
        held.agreement[static_cast<std::size_t>(cell.y) * SkinFrames::kSize + static_cast<std::size_t>(cell.x)];
    if (known < 0.0F) {
        const glm::vec2 middle = (glm::vec2(cell) + 0.5F) / static_cast<float>(SkinFrames::kSize);
        const std::optional<FramedPoint>& there = m_frames->point(cell.x, cell.y);
        const float along = there ? glm::dot(lyingHd({middle.x, 1.0F - middle.y}, there->frame), held.lyingHd) : 1.0F;
        known = std::clamp((along - kUnlike) / (kAlike - kUnlike), 0.0F, 1.0F);
    }
    return known;
}

/// Hair that is held has at least that gel.
void GrabTool::layGel(const ToolSettings& settings)
{
    const std::uint16_t least = unit16(settings.grabGel);
    const auto gelled = [&](int index, const sim::RasterTilePtr& before) {
        StrokeBuffer::MaskTile mask = *m_gelMasks->mask(index);
        const sim::TexelRect rect = m_gelBefore->tileRect(index);
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel)
                if (m_gelBefore->texel(x, y)[0] >= least)
                    mask[texel] = 0;
        return paintTile(m_edit.spec(*m_gel), before, mask, {.value = {least}, .opacity = unit16(settings.opacity)});
    };
    m_edit.update(m_gelTiles, gelled, *m_gel);
}

/// All take the direction of the hair that is held, `flatness` aside, each in the frame of its root.
void GrabTool::layDirections(glm::vec3 directionHd, std::optional<float> flatness, const ToolSettings& settings)
{
    const int size = m_edit.size();
    CombField field(size);
    for (const Held& held : m_held) {
        const glm::vec3 ownHd = directionHd * held.across;
        const sim::SkinFrame centre = sim::SkinFrame::at(held.root);
        const Dab dab = dabAt(SkinMetric::at(held.root), held.root.uv, 0.5F * settings.brushSizeM, size);
        field.add(dab, [&](int x, int y) -> std::optional<glm::vec2> {
            const glm::vec2 position = (glm::vec2(x, y) + 0.5F) / static_cast<float>(size);
            const sim::SkinFrame frame = m_frames->at({position.x, 1.0F - position.y}).value_or(centre);
            const glm::vec2 inPlane = frame.fromHd(ownHd);
            const float length = glm::length(inPlane);
            // What would go into the head lies flat on it.
            const bool intoTheHead = glm::dot(ownHd, frame.normal) < 0.0F;
            const float wanted = flatness.value_or(intoTheHead ? 1.0F : length);
            return length > 1e-4F ? inPlane * (wanted / length) : glm::vec2(0.0F);
        });
    }
    const std::uint16_t opacity = unit16(settings.opacity);
    m_edit.update(m_tiles, [&](int index, const sim::RasterTilePtr& before) {
        const std::vector<std::uint16_t> values = field.values(index);
        const StrokeBuffer::MaskTile& mask = *m_masks->mask(index);
        m_before->look(index);
        return paintTile(m_edit.spec(), m_before->under(index, before, mask), mask,
                         {.values = values.data(), .opacity = opacity});
    });
}

/// Hair that is held where it hangs is bent there; that which stands is turned at its root.
void GrabTool::takeCourse(const GrabbedHair& hair, const ToolContext& context)
{
    m_course.clear();
    const HairGroup* group = context.document.project().group(context.target.group);
    if (hair.alongM <= 0.0F || group == nullptr)
        return;
    const bool isGuide = context.settings.grab == GrabKind::Guides;
    if (!isGuide && hair.alongM < kHangs * group->settings.physics.stiffnessM)
        return;
    std::optional<HairCourse> course = courseOf(context, hair.root);
    if (!course)
        return;
    m_course = std::move(*course);
    m_courseNode = nodeAlong(m_course, hair.alongM);
    for (GuideStrand& guide : m_guides)
        guide.held = glm::distance(guide.nodesHd.front(), m_course.front()) < kStillM;
}

/// The hair is bent to the pointer; it and what lies around it takes that course over the skin.
void GrabTool::layCourse(glm::vec3 targetHd, const ToolSettings& settings)
{
    std::vector<HairCourse> courses(m_held.size(), m_course);
    bendHair(courses.front(), m_courseNode, targetHd);
    for (GuideStrand& guide : m_guides)
        if (guide.held)
            guide.nodesHd = courses.front();
    for (std::size_t i = 1; i < courses.size(); ++i)
        for (std::size_t node = 0; node < m_course.size(); ++node)
            courses[i][node] = courses.front()[node] * m_held[i].across;
    LaidHair laid = layAlong(courses, {.radiusM = 0.5F * settings.brushSizeM, .hardness = settings.hardness}, *m_frames,
                             m_edit.size(), m_edit.clips());
    const std::uint16_t opacity = unit16(settings.opacity);
    m_edit.replace(laid.masks.takeDirty(), [&](int index, const sim::RasterTilePtr& before) {
        const std::vector<std::uint16_t> values = laid.field.values(index);
        const StrokeBuffer::MaskTile& mask = *laid.masks.mask(index);
        m_before->look(index);
        return paintTile(m_edit.spec(), m_before->under(index, before, mask), mask,
                         {.values = values.data(), .opacity = opacity});
    });
}

/// As long as before times `factor`, as far as the map goes.
void GrabTool::layLengths(float factor, const sim::GroupSettings& group, const ToolSettings& settings)
{
    const float rangeM = std::max(group.greatestLengthM - group.shortestLengthM, 1e-6F);
    const auto lengthened = [&](int index, const sim::RasterTilePtr& before) {
        std::vector<std::uint16_t> values(sim::kTileTexels);
        const sim::TexelRect rect = m_lengthBefore->tileRect(index);
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                const float value = static_cast<float>(m_lengthBefore->texel(x, y)[0]) / 65535.0F;
                const float lengthM = (group.shortestLengthM + rangeM * value) * factor;
                values[texel] = unit16(std::clamp((lengthM - group.shortestLengthM) / rangeM, 0.0F, 1.0F));
            }
        return paintTile(m_edit.spec(*m_length), before, *m_lengthMasks->mask(index),
                         {.values = values.data(), .opacity = unit16(settings.opacity)});
    };
    m_edit.update(m_lengthTiles, lengthened, *m_length);
}

void GrabTool::drop()
{
    m_length.reset();
    m_gel.reset();
    m_lengthBefore.reset();
    m_gelBefore.reset();
    m_before.reset();
    m_course.clear();
    m_guides.clear();
    m_masks.reset();
    m_lengthMasks.reset();
    m_gelMasks.reset();
    m_held.clear();
}

} // namespace

std::unique_ptr<Tool> makeGrabTool()
{
    return std::make_unique<GrabTool>();
}

} // namespace hairpaint::model
