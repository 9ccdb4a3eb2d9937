// The line at the window's foot.
#include "view/panels/status_readout.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"
#include "view/widgets/revealed_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kLimitMs = 12'000; ///< For reading what to do about it.

/// Numbers stand in a field as wide as the widest of them, so that the line does not twitch.
QLabel* makeNumber(QWidget* parent, const QString& widest)
{
    auto* label = new QLabel(parent);
    label->setProperty("role", QStringLiteral("status"));
    label->setFont(themeFont(TextRole::Status));
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 2);
    return label;
}

/// Digits of equal width: Inter's own are proportional, so a figure space fills the column of missing ones and digits
/// come from the font's tabular set where Qt can ask for it.
QString padded(const QString& number, qsizetype digits)
{
    return number.rightJustified(digits, QChar(0x2007));
}

/// Empty where no limit is felt.
QString whyFewer(sim::HairLimit limit)
{
    switch (limit) {
    case sim::HairLimit::None:
        break;
    case sim::HairLimit::MaxHairs:
        return StatusReadout::tr("Fewer hairs than painted: the project's limit is reached. A lower greatest density "
                                 "leaves room.");
    case sim::HairLimit::Memory:
        return StatusReadout::tr("Fewer hairs than painted: memory would not hold more. Fewer nodes per hair or a "
                                 "lower greatest density leave room.");
    }
    return {};
}

} // namespace

StatusReadout::StatusReadout(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("statusReadout"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(metrics::kStatus);
    setAccessibleName(tr("Status"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, 0, metrics::kPadding, 0);
    layout->setSpacing(metrics::kGap);
    m_errorIcon = new QLabel(this);
    m_errorIcon->hide();
    m_hint = new QLabel(this);
    m_hint->setProperty("role", QStringLiteral("status"));
    m_hint->setFont(themeFont(TextRole::Status));
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    const model::MapSpec& density = model::mapSpec(model::MapKind::Density);
    const model::MapSpec& direction = model::mapSpec(model::MapKind::Direction);
    const model::PaintValue most{.scalar = 1.0F, .direction = {1.0F, -1e-3F}};
    QString widest;
    for (const model::MapSpec* spec : {&density, &direction}) {
        const QString text = tr("%1: %2").arg(spec->titleText(), valueText({}, *spec, most));
        const QFontMetrics status(themeFont(TextRole::Status));
        if (status.horizontalAdvance(text) > status.horizontalAdvance(widest))
            widest = text;
    }
    m_value = makeNumber(this, widest);
    m_hairs = makeNumber(this, tr("%1 of %Ln hairs", nullptr, 100000).arg(QLocale().toString(100000)));
    m_simulation = makeNumber(this, tr("%1 ms").arg(QStringLiteral("000.0")));
    m_simulation->setToolTip(tr("Time of one step of the simulation"));
    m_frames = makeNumber(this, tr("%1 fps").arg(QStringLiteral("000")));
    m_frames->setToolTip(tr("Pictures per second"));
    layout->addWidget(m_errorIcon);
    m_saved = new QLabel(this);
    m_saved->setObjectName(QStringLiteral("saved"));
    m_saved->setProperty("role", QStringLiteral("status"));
    m_saved->setFont(themeFont(TextRole::Status));
    layout->addWidget(m_hint, 1);
    layout->addWidget(m_saved);
    for (QLabel* label : {m_value, m_hairs, m_simulation, m_frames})
        layout->addWidget(label);
    m_message.setSingleShot(true);
    connect(&m_message, &QTimer::timeout, this, &StatusReadout::follow);
    connect(&state.tools(), &ToolBox::activeChanged, this, &StatusReadout::follow);
    connect(&state.hover(), &Hover::changed, this, &StatusReadout::followHover);
    connect(&state.target(), &EditTarget::changed, this, &StatusReadout::followHover);
    connect(&state.target(), &EditTarget::changed, this, [this] {
        if (!m_message.isActive())
            follow();
    });
    // A tool that runs, or does another thing, says something else next.
    for (const auto changed : {&ToolBox::overlayChanged, &ToolBox::settingsChanged})
        connect(&state.tools(), changed, this, [this] {
            if (!m_message.isActive())
                follow();
        });
    connect(&state, &EditorState::refused, this, [this](const QString& reason) { showMessage(reason, true); });
    connect(&state, &EditorState::told, this, [this](const QString& text) { showMessage(text, false); });
    follow();
}

void StatusReadout::setHairs(qint64 drawn, qint64 all, sim::HairLimit limit)
{
    const int total = static_cast<int>(all);
    const QString hairs = drawn == all ? tr("%Ln hairs", nullptr, total)
                                       : tr("%1 of %Ln hairs", nullptr, total).arg(QLocale().toString(drawn));
    m_hairs->setText(limit == sim::HairLimit::None ? hairs : tr("%1, limit reached").arg(hairs));
    m_hairs->setToolTip(whyFewer(limit));
    if (std::exchange(m_limit, limit) != limit && limit != sim::HairLimit::None)
        showMessage(whyFewer(limit), true, kLimitMs);
}

void StatusReadout::setSimulationMs(double milliseconds)
{
    if (m_paused)
        return;
    m_simulation->setText(tr("%1 ms").arg(padded(QLocale().toString(milliseconds, 'f', 1), 5)));
}

void StatusReadout::setPaused(bool paused)
{
    m_paused = paused;
    m_simulation->setText(paused ? tr("Paused") : QString());
}

void StatusReadout::setSaved(Saved saved)
{
    m_savedState = saved;
    if (saved == Saved::No && !m_unprotected.isEmpty()) {
        m_saved->setText(tr("▲ Not saved, no safety copy"));
        m_saved->setToolTip(tr("A crash would lose what is not saved: the program could not keep a copy of it "
                               "(%1). Save it now and then.")
                                .arg(m_unprotected));
        return;
    }
    m_saved->setText(saved == Saved::No ? tr("● Not saved") : saved == Saved::Yes ? tr("✓ Saved") : QString());
    m_saved->setToolTip(saved == Saved::No ? tr("Changes that no file holds yet; Ctrl+S saves them") : QString());
}

void StatusReadout::setUnprotected(const QString& reason)
{
    m_unprotected = reason;
    setSaved(m_savedState);
}

QString StatusReadout::savedText() const
{
    return m_saved->text();
}

void StatusReadout::setFramesPerSecond(double frames)
{
    m_frames->setText(frames > 0.0 ? tr("%1 fps").arg(padded(QLocale().toString(qRound(frames)), 3)) : QString());
}

void StatusReadout::showMessage(const QString& text, bool error, int milliseconds)
{
    m_hint->setText(text);
    m_hint->setToolTip(text);
    m_errorIcon->setVisible(error);
    if (error)
        m_errorIcon->setPixmap(iconPixmap(QStringLiteral("error"), 16, Theme::current().error, devicePixelRatioF()));
    m_message.start(milliseconds);
}

void StatusReadout::follow()
{
    m_message.stop();
    m_errorIcon->hide();
    const QString revealed = revealedText(m_state);
    const QString hint = m_state.tools().active().hintFor(m_state.tools().settings());
    m_hint->setText(revealed.isEmpty() ? hint : tr("%1. Erasing %2").arg(hint, revealed));
    m_hint->setToolTip(m_hint->text());
}

void StatusReadout::followHover()
{
    const model::HairGroup* group = m_state.document().project().group(m_state.target().group());
    const auto& hover = m_state.hover().at();
    const auto resolved = m_state.document().resolved(m_state.target().group(), m_state.target().map());
    if (group == nullptr || !hover || !hover->point || resolved == nullptr) {
        m_value->clear();
        return;
    }
    const model::MapSpec& spec = model::mapSpec(m_state.target().map());
    model::PaintValue value = valueOfTexel(spec, resolved->sampleNearest(hover->point->uv));
    m_value->setText(tr("%1: %2").arg(spec.titleText(), valueText(group->settings, spec, value)));
}

} // namespace hairpaint::view
