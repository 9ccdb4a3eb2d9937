// The maps of the active group.
#include "view/panels/maps_panel.h"

#include "view/look/theme.h"
#include "view/look/value_text.h"
#include "view/panels/map_row.h"
#include "view/panels/map_thumbnail.h"

#include <QKeyEvent>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

using model::Change;
using model::MapKind;
using model::MapSpec;

namespace {

constexpr int kRedrawMs = 50;
constexpr int kLeastRows = 10; ///< Where the window is low; to the others it scrolls.

} // namespace

MapsPanel::MapsPanel(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_scroll(new QScrollArea(this))
{
    setObjectName(QStringLiteral("panel"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Maps"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(m_scroll);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->installEventFilter(this);
    auto* content = new QWidget(m_scroll);
    content->setObjectName(QStringLiteral("panel"));
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(metrics::kPadding - metrics::kGrid, metrics::kGrid, metrics::kPadding - metrics::kGrid,
                               metrics::kGap);
    layout->setSpacing(0);
    for (const MapSpec& spec : model::mapSpecs()) {
        auto* row = new MapRow(spec.kind, content);
        connect(row, &MapRow::clicked, this, [this, kind = spec.kind] { m_state.target().setMap(kind); });
        layout->addWidget(row);
        m_rows[sim::indexOf(spec.kind)] = row;
    }
    m_scroll->setWidget(content);
    m_scroll->setMinimumHeight(kLeastRows * m_rows.front()->minimumSizeHint().height());
    m_redraw.setSingleShot(true);
    m_redraw.setInterval(kRedrawMs);
    connect(&m_redraw, &QTimer::timeout, this, &MapsPanel::redraw);
    connect(&state.target(), &EditTarget::changed, this, &MapsPanel::follow);
    connect(&state.options(), &ViewOptions::changed, this, &MapsPanel::markAll);
    connect(&state.document(), &model::Document::changed, this, &MapsPanel::onChanged);
    m_shownMap = state.target().map();
    follow();
    markAll();
}

QSize MapsPanel::sizeHint() const
{
    return m_scroll->widget()->sizeHint();
}

void MapsPanel::onChanged(const Change& change)
{
    const bool oneMap = change.aspect == Change::Aspect::Texels || change.aspect == Change::Aspect::LayerList ||
                        change.aspect == Change::Aspect::Resolved;
    if (oneMap) {
        if (change.group != m_shownGroup)
            return;
        if (change.aspect == Change::Aspect::LayerList)
            follow(); // It may have another size.
        if (!m_redraw.isActive())
            m_redraw.start();
    } else if (change.aspect != Change::Aspect::Environment && change.aspect != Change::Aspect::Head) {
        follow();
        if (change.aspect != Change::Aspect::Settings)
            markAll();
    }
}

void MapsPanel::markAll()
{
    m_drawn.fill(nullptr);
    if (!m_redraw.isActive())
        m_redraw.start();
}

void MapsPanel::follow()
{
    const model::HairGroup* group = m_state.document().project().group(m_state.target().group());
    setEnabled(group != nullptr);
    for (const MapSpec& spec : model::mapSpecs()) {
        MapRow* row = m_rows[sim::indexOf(spec.kind)];
        row->setChecked(spec.kind == m_state.target().map());
        row->setRange(group != nullptr ? rangeText(group->settings, spec) : QString(),
                      group != nullptr ? group->map(spec.kind).size : 0);
    }
    if (m_state.target().map() != m_shownMap) {
        m_shownMap = m_state.target().map();
        m_scroll->ensureWidgetVisible(m_rows[sim::indexOf(m_shownMap)], 0, 0);
    }
    if (m_shownGroup != m_state.target().group()) {
        m_shownGroup = m_state.target().group();
        markAll();
    }
}

void MapsPanel::redraw()
{
    const int side = qRound(MapRow::kThumbnailSide * devicePixelRatioF());
    for (const MapSpec& spec : model::mapSpecs()) {
        const auto resolved = m_state.document().resolved(m_shownGroup, spec.kind);
        auto& drawn = m_drawn[sim::indexOf(spec.kind)];
        if (resolved != nullptr && resolved == drawn)
            continue;
        drawn = resolved;
        m_rows[sim::indexOf(spec.kind)]->setThumbnail(
            resolved == nullptr ? QImage() : mapThumbnail(*resolved, spec, m_state.options().nightPaper(), side));
    }
}

void MapsPanel::keyPressEvent(QKeyEvent* event)
{
    int wanted = -1;
    const int current = static_cast<int>(m_state.target().map());
    if (event->key() >= Qt::Key_0 && event->key() <= Qt::Key_9)
        wanted = (event->key() - Qt::Key_0 + MapRow::kDigits - 1) % MapRow::kDigits;
    else if (event->key() == Qt::Key_Up)
        wanted = std::max(current - 1, 0);
    else if (event->key() == Qt::Key_Down)
        wanted = std::min(current + 1, model::kMapKindCount - 1);
    if (wanted < 0 || wanted >= model::kMapKindCount) {
        QWidget::keyPressEvent(event);
        return;
    }
    m_state.target().setMap(static_cast<MapKind>(wanted));
    m_rows[static_cast<std::size_t>(wanted)]->setFocus();
}

/// Arrows choose a map; they would scroll.
bool MapsPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_scroll || event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    keyPressEvent(static_cast<QKeyEvent*>(event));
    return true;
}

} // namespace hairpaint::view
