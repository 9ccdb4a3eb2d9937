// The legend of a map's colours.
#include "view/head/map_legend.h"

#include "view/theme.h"
#include "view/widgets/value_text.h"

#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr int kWidth = 184;
constexpr int kBar = 12;
constexpr int kLine = 18;

} // namespace

MapLegend::MapLegend(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("What the colours mean"));
    hide();
}

void MapLegend::showMap(const model::MapSpec& spec, const sim::GroupSettings& settings)
{
    m_title = spec.titleText();
    m_labels.clear();
    m_colours.clear();
    m_isScale = spec.scale != nullptr;
    if (m_isScale) {
        m_labels.append(rangeText(settings, spec));
        m_colours = scaleGradient(spec, false);
    }
    for (const model::PaletteEntry& entry : spec.palette) {
        m_labels.append(entry.titleText());
        m_colours.append(QColor(entry.colour));
    }
    const int lines = static_cast<int>(m_labels.size()) + 1;
    resize(kWidth, 2 * metrics::kPadding + lines * kLine + (m_isScale ? kBar + metrics::kGrid : 0));
    if (const QWidget* area = parentWidget())
        move(metrics::kPadding, area->height() - height() - metrics::kPadding);
    show();
    raise();
    update();
}

void MapLegend::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme.line);
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius, metrics::kRadius);
    QRect line = rect().adjusted(metrics::kPadding, metrics::kPadding, -metrics::kPadding, -metrics::kPadding);
    line.setHeight(kLine);
    painter.setFont(themeFont(TextRole::Label));
    painter.setPen(theme.text);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_title);
    line.translate(0, kLine);
    painter.setFont(themeFont(TextRole::Status));
    if (m_isScale) {
        const QRectF bar(line.left(), line.top() + 2, line.width(), kBar);
        QLinearGradient gradient(bar.topLeft(), bar.topRight());
        for (qsizetype i = 0; i < m_colours.size(); ++i)
            gradient.setColorAt(static_cast<double>(i) /
                                    static_cast<double>(std::max<qsizetype>(m_colours.size() - 1, 1)),
                                m_colours[i]);
        painter.setPen(Qt::NoPen);
        painter.setBrush(gradient);
        painter.drawRoundedRect(bar, 2, 2);
        line.translate(0, kBar + metrics::kGrid);
    }
    for (qsizetype i = 0; i < m_labels.size(); ++i, line.translate(0, kLine)) {
        QRect text = line;
        if (!m_isScale) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(m_colours[i]);
            painter.drawRoundedRect(QRectF(line.left(), line.top() + 3, kBar, kBar), 2, 2);
            text.setLeft(line.left() + kBar + metrics::kGap);
        }
        painter.setPen(theme.dimText);
        painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, m_labels[i]);
    }
}

} // namespace hairpaint::view
