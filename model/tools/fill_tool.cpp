// Flood fill: the connected texels of the skin whose value is like the one clicked.
#include "model/compositor.h"
#include "model/tools/live_edit.h"
#include "model/tools/mirror.h"
#include "model/tools/picker.h"
#include "model/tools/tool_list.h"
#include "model/tools/uv_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hairpaint::model {

namespace {

constexpr int kBleedTx = 4;

/// Whole texels one after the other; floods through 4-connected neighbours.
class Flood
{
public:
    Flood(const sim::TiledRaster& map, const MapSpec& spec, std::vector<std::uint8_t> allowed, float tolerance)
        : m_map(map), m_spec(spec), m_allowed(std::move(allowed)), m_filled(m_allowed.size()),
          m_tolerance(spec.texel == TexelKind::Index ? 0 : static_cast<int>(unit16(tolerance)))
    {}

    void from(int seedX, int seedY)
    {
        if (seedX < 0 || seedY < 0 || seedX >= m_map.size() || seedY >= m_map.size() || !open(seedX, seedY))
            return;
        m_seed = m_map.texel(seedX, seedY);
        m_pending = {{seedX, seedY}};
        m_filled[at(seedX, seedY)] = 1;
        while (!m_pending.empty()) {
            const auto [x, y] = m_pending.back();
            m_pending.pop_back();
            visit(x - 1, y);
            visit(x + 1, y);
            visit(x, y - 1);
            visit(x, y + 1);
        }
    }
    [[nodiscard]] std::vector<std::uint8_t> takeFilled() { return std::move(m_filled); }

private:
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_map.size()) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool open(int x, int y) const { return m_allowed[at(x, y)] != 0 && m_filled[at(x, y)] == 0; }
    [[nodiscard]] bool alike(int x, int y) const
    {
        const sim::Texel texel = m_map.texel(x, y);
        for (std::size_t i = 0; i < static_cast<std::size_t>(m_spec.valueChannels); ++i)
            if (std::abs(static_cast<int>(texel[i]) - static_cast<int>(m_seed[i])) > m_tolerance)
                return false;
        return true;
    }
    void visit(int x, int y)
    {
        if (x < 0 || y < 0 || x >= m_map.size() || y >= m_map.size() || !open(x, y) || !alike(x, y))
            return;
        m_filled[at(x, y)] = 1;
        m_pending.emplace_back(x, y);
    }

    const sim::TiledRaster& m_map;
    const MapSpec& m_spec;
    std::vector<std::uint8_t> m_allowed, m_filled;
    int m_tolerance;
    sim::Texel m_seed{};
    std::vector<std::pair<int, int>> m_pending;
};

class FillTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] ToolId id() const override { return ToolId::Fill; }
    [[nodiscard]] QString title() const override { return tr("Fill"); }
    [[nodiscard]] QKeySequence defaultKey() const override { return Qt::SHIFT | Qt::Key_G; }
    [[nodiscard]] QString hint() const override
    {
        return tr("Click to fill what has a similar value around the pointer");
    }
    [[nodiscard]] std::vector<ToolOption> options() const override
    {
        return {ToolOption::Value, ToolOption::FillTolerance, ToolOption::Opacity};
    }

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
        const auto map = context.document.resolved(context.target.group, context.target.map);
        const Head* head = context.document.project().head.get();
        std::vector<std::uint8_t> skin(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 1);
        if (head != nullptr && head->skin != nullptr)
            skin = uvCover(head->skin->mesh(), size);
        std::vector<std::uint8_t> allowed = skin;
        keepInside(allowed, size, m_edit.clips());

        Flood flood(*map, m_edit.spec(), std::move(allowed), context.settings.fillTolerance);
        const auto from = [&](glm::vec2 seed) {
            flood.from(static_cast<int>(std::floor(seed.x * static_cast<float>(size))),
                       static_cast<int>(std::floor((1.0F - seed.y) * static_cast<float>(size))));
        };
        from(uv);
        if (context.mirror)
            if (const std::optional<glm::vec2> other = mirroredUv(head, uv))
                from(*other);
        std::vector<std::uint8_t> filled = flood.takeFilled();
        bleedOffSkin(filled, skin);
        keepInside(filled, size, m_edit.clips());
        show(filled, context);
    }

    /// Past the islands' borders only: on the skin the fill ends where the values differ.
    void bleedOffSkin(std::vector<std::uint8_t>& filled, const std::vector<std::uint8_t>& skin) const
    {
        bleed(filled, m_edit.size(), kBleedTx);
        for (std::size_t i = 0; i < filled.size(); ++i)
            if (filled[i] == 2 && skin[i] != 0)
                filled[i] = 0;
    }

    static void keepInside(std::vector<std::uint8_t>& texels, int size, const std::vector<sim::TexelRect>& clips)
    {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (!contains(clips, x, y))
                    texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)] =
                        0;
    }

    void show(const std::vector<std::uint8_t>& filled, ToolContext& context)
    {
        const TilePaint paint{.value = context.settings.value(context.target.map).texel(m_edit.spec()),
                              .opacity = unit16(context.settings.opacity)};
        const int size = m_edit.size();
        m_edit.update(tilesIn(m_edit.before(), m_edit.clips()), [&](int index, const sim::RasterTilePtr& before) {
            StrokeBuffer::MaskTile mask{};
            const sim::TexelRect rect = m_edit.before().tileRect(index);
            std::size_t texel = 0;
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, ++texel)
                    mask[texel] = filled[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                                         static_cast<std::size_t>(x)] != 0
                                      ? 65535
                                      : 0;
            return paintTile(m_edit.spec(), before, mask, paint);
        });
    }

    LiveEdit m_edit;
};

} // namespace

std::unique_ptr<Tool> makeFillTool()
{
    return std::make_unique<FillTool>();
}

} // namespace hairpaint::model
