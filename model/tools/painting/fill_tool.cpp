// Flood fill: the connected texels of the skin whose value is like the one clicked.
#include "model/maps/compositor.h"
#include "model/maps/texel_ops.h"
#include "model/tools/live_edit.h"
#include "model/tools/painting/uv_cover.h"
#include "model/tools/picker_tool.h"
#include "model/tools/row_number.h"
#include "model/tools/strokes/mirror.h"
#include "model/tools/tool_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace hairpaint::model {

namespace {

constexpr ToolOption kTolerance{.key = "fill_tolerance",
                                .label = QT_TRANSLATE_NOOP("ToolOptions", "Tolerance"),
                                .kind = ToolNumber{.field = &ToolSettings::fillTolerance, .standard = 5.0}};
constexpr std::array kFillOptions{&kValueOption, &kTolerance, &kOpacityOption};

constexpr int kBleedTx = 4;

/// Floods through 4-connected neighbours, a run of a row at a time.
class Flood
{
public:
    Flood(const sim::TiledRaster& map, const MapSpec& spec, TexelMask allowed, float tolerance)
        : m_map(map), m_spec(spec), m_allowed(std::move(allowed)), m_filled(m_allowed.size()),
          m_tolerance(texelOps(spec).continuous ? static_cast<int>(unit16(tolerance)) : 0)
    {}

    void from(int seedX, int seedY)
    {
        if (seedX < 0 || seedY < 0 || seedX >= m_map.size() || seedY >= m_map.size() || !open(seedX, seedY))
            return;
        m_seed = m_map.texel(seedX, seedY);
        m_pending = {{seedX, seedY}};
        while (!m_pending.empty()) {
            const auto [x, y] = m_pending.back();
            m_pending.pop_back();
            if (!floods(x, y))
                continue; // Another run has been there.
            int x0 = x;
            int x1 = x + 1;
            while (x0 > 0 && floods(x0 - 1, y))
                --x0;
            while (x1 < m_map.size() && floods(x1, y))
                ++x1;
            m_filled.set(y, x0, x1);
            for (const int next : {y - 1, y + 1})
                beginRuns(next, x0, x1);
        }
    }
    [[nodiscard]] const TexelMask& filled() const { return m_filled; }

private:
    [[nodiscard]] bool open(int x, int y) const { return m_allowed.at(x, y) && !m_filled.at(x, y); }
    [[nodiscard]] bool alike(int x, int y) const
    {
        const sim::Texel texel = m_map.texel(x, y);
        for (std::size_t i = 0; i < static_cast<std::size_t>(m_spec.valueChannels); ++i)
            if (std::abs(static_cast<int>(texel[i]) - static_cast<int>(m_seed[i])) > m_tolerance)
                return false;
        return true;
    }
    [[nodiscard]] bool floods(int x, int y) const { return open(x, y) && alike(x, y); }
    void beginRuns(int y, int x0, int x1)
    {
        if (y < 0 || y >= m_map.size())
            return;
        bool before = false;
        for (int x = x0; x < x1; ++x) {
            const bool here = floods(x, y);
            if (here && !before)
                m_pending.emplace_back(x, y);
            before = here;
        }
    }

    const sim::TiledRaster& m_map;
    const MapSpec& m_spec;
    TexelMask m_allowed, m_filled;
    int m_tolerance;
    sim::Texel m_seed{};
    std::vector<std::pair<int, int>> m_pending;
};

constexpr ToolTraits kFill{
    .id = ToolId::Fill,
    .name = "fill",
    .title = QT_TRANSLATE_NOOP("Tool", "Fill"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Fills a whole patch, or the whole map, with the chosen value."),
    .hint = QT_TRANSLATE_NOOP("Tool", "Click to fill what has a similar value around the pointer"),
    .key = Qt::SHIFT | Qt::Key_G,
    .options = kFillOptions};

class FillTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kFill; }

    void press(const ToolEvent& event, ToolContext& context) override
    {
        if (picksInstead(event, context) || active() || (event.area == Area::Head && !event.point))
            return;
        if (m_edit.begin(context, title()))
            fill(event.uv, context);
    }
    void move(const ToolEvent& /*event*/, ToolContext& /*context*/) override {}
    void release(const ToolEvent& /*event*/, ToolContext& context) override { commit(context); }
    void cancel(ToolContext& /*context*/) override { m_edit.cancel(); }
    void commit(ToolContext& /*context*/) override { m_edit.commit(); }
    [[nodiscard]] bool active() const override { return m_edit.active(); }

private:
    void fill(glm::vec2 uv, ToolContext& context)
    {
        const int size = m_edit.size();
        const auto map = context.document.resolvedNow(context.target.group, context.target.map);
        const Head* head = context.document.project().head.get();
        const bool hasSkin = head != nullptr && head->skin != nullptr;
        const TexelMask skin = hasSkin ? m_cover.of(head->skin, size) : TexelMask(size, true);
        TexelMask allowed = skin;
        allowed.keepInside(m_edit.clips());

        Flood flood(*map, m_edit.spec(), std::move(allowed), context.settings.fillTolerance);
        const auto from = [&](glm::vec2 seed) {
            flood.from(static_cast<int>(std::floor(seed.x * static_cast<float>(size))),
                       static_cast<int>(std::floor((1.0F - seed.y) * static_cast<float>(size))));
        };
        from(uv);
        const TexelMask near = flood.filled();
        if (context.mirror)
            if (const std::optional<glm::vec2> other = mirroredUv(head, uv))
                from(*other);
        // Past the islands' borders only: on the skin the fill ends where the values differ.
        TexelMask filled = flood.filled().grown(kBleedTx);
        filled.remove(skin);
        filled.add(flood.filled());
        filled.keepInside(m_edit.clips());
        const std::optional<sim::SurfacePoint> at = hasSkin ? head->skin->atUv(uv) : std::nullopt;
        const sim::Texel value = strokeTexel(context, {.area = Area::Paint, .uv = uv});
        const sim::Texel twin = mirroredValue(m_edit.spec(), value, head, at);
        show(filled, {.value = value, .opacity = unit16(context.settings.opacity)}, twin, near.grown(kBleedTx));
    }

    /// `twin`: instead of the paint's value outside of `near`, where it is another.
    void show(const TexelMask& filled, TilePaint paint, const sim::Texel& twin, const TexelMask& near)
    {
        std::vector<int> tiles = tilesIn(m_edit.before(), m_edit.clips());
        std::erase_if(tiles, [&](int index) { return !filled.any(m_edit.before().tileRect(index)); });
        const auto channels = static_cast<std::size_t>(m_edit.spec().valueChannels);
        std::vector<std::uint16_t> values(twin == paint.value ? 0 : sim::kTileTexels * channels);
        if (!values.empty())
            paint.values = values.data();
        m_edit.update(tiles, [&](int index, const sim::RasterTilePtr& before) {
            StrokeBuffer::MaskTile mask{};
            const sim::TexelRect rect = m_edit.before().tileRect(index);
            std::size_t texel = 0;
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, ++texel) {
                    mask[texel] = filled.at(x, y) ? 65535 : 0;
                    if (!values.empty())
                        std::copy_n((near.at(x, y) ? paint.value : twin).begin(), channels,
                                    values.begin() + static_cast<std::ptrdiff_t>(texel * channels));
                }
            return paintTile(m_edit.spec(), before, mask, paint);
        });
    }

    LiveEdit m_edit;
    UvCover m_cover;
};

} // namespace

std::unique_ptr<Tool> makeFillTool()
{
    return std::make_unique<FillTool>();
}

} // namespace hairpaint::model
