// Size, framing, background, quality, and the small picture.
#include "view/dialogs/picture_dialog.h"

#include "view/look/theme.h"
#include "view/widgets/number_spin_box.h"
#include "view/widgets/swatch.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kPreviewPx = 260;
constexpr std::array kSampleCounts{1, 4, 16};

struct NamedSize
{
    const char* title;
    QSize px;
};

/// Those of the list between "as the 3D area" and "own size".
constexpr std::array<NamedSize, 6> kSizes = {{
    {QT_TRANSLATE_NOOP("hairpaint::view::PictureDialog", "Square"), {2048, 2048}},
    {QT_TRANSLATE_NOOP("hairpaint::view::PictureDialog", "Large square"), {4096, 4096}},
    {QT_TRANSLATE_NOOP("hairpaint::view::PictureDialog", "Portrait"), {1536, 2048}},
    {QT_TRANSLATE_NOOP("hairpaint::view::PictureDialog", "1080p"), {1920, 1080}},
    {QT_TRANSLATE_NOOP("hairpaint::view::PictureDialog", "1080p upright"), {1080, 1920}},
    {QT_TRANSLATE_NOOP("hairpaint::view::PictureDialog", "4K"), {3840, 2160}},
}};
constexpr int kAsView = 0;
constexpr int kFirstNamed = 1;
constexpr int kOwn = kFirstNamed + static_cast<int>(kSizes.size());

int indexOf(QSize px)
{
    const auto found = std::ranges::find_if(kSizes, [px](const NamedSize& size) { return size.px == px; });
    return kFirstNamed + static_cast<int>(found - kSizes.begin()); // kOwn where it is none of them.
}

QSize bounded(QSize px)
{
    return px.expandedTo({PictureChoice::kLeastPx, PictureChoice::kLeastPx})
        .boundedTo({PictureChoice::kMostPx, PictureChoice::kMostPx});
}

/// Squares that stand for no background.
QPixmap onSquares(const QImage& picture)
{
    constexpr int kSide = 8;
    QPixmap shown(picture.size());
    shown.fill(QColor(0x99, 0x99, 0x99));
    QPainter painter(&shown);
    for (int y = 0; y < picture.height(); y += kSide)
        for (int x = (y / kSide) % 2 * kSide; x < picture.width(); x += 2 * kSide)
            painter.fillRect(x, y, kSide, kSide, QColor(0x66, 0x66, 0x66));
    painter.drawImage(0, 0, picture);
    return shown;
}

} // namespace

PictureDialog::PictureDialog(const PictureChoice& before, QSize viewPx, QWidget* parent)
    : QDialog(parent), m_viewPx(bounded(viewPx))
{
    constexpr int kMargin = 16;
    setWindowTitle(tr("Save picture"));
    auto* row = new QHBoxLayout;
    row->setSpacing(kMargin);
    row->addLayout(buildForm(), 1);
    row->addLayout(buildSide());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    QPushButton* save = buttons->button(QDialogButtonBox::Save);
    save->setText(tr("Save…"));
    save->setDefault(true);
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false); // Enter is Save wherever the focus is.
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(metrics::kPadding);
    layout->addLayout(row);
    layout->addWidget(buttons);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, [this] {
        m_isAsked = true;
        Q_EMIT previewWanted();
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &PictureDialog::saveWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(before);
}

PictureDialog::~PictureDialog()
{
    hide(); // Fields that are hidden tell what was typed last, to a dialog that is whole.
}

QComboBox* PictureDialog::addChoice(QFormLayout& form, const QString& label, const QStringList& texts)
{
    auto* box = new QComboBox(this);
    box->addItems(texts);
    form.addRow(label, box);
    connect(box, &QComboBox::currentIndexChanged, this, &PictureDialog::follow);
    return box;
}

QLayout* PictureDialog::buildForm()
{
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addSizeRows(*form);
    m_framing = addChoice(*form, tr("&Framing"),
                          {tr("As in the 3D area"), tr("Head and all hair"), tr("Head"), tr("Whole bust")});
    m_framing->setToolTip(
        tr("All are seen from where the 3D area looks; turn the view there, also while this is open."));
    addBackgroundRow(*form);
    m_samples =
        addChoice(*form, tr("&Quality"),
                  {tr("Quick, 1 sample a pixel"), tr("Fine, 4 samples a pixel"), tr("Finest, 16 samples a pixel")});
    return form;
}

void PictureDialog::addSizeRows(QFormLayout& form)
{
    QStringList texts{tr("As the 3D area")};
    for (const NamedSize& size : kSizes)
        texts += tr("%1, %2 × %3").arg(tr(size.title)).arg(size.px.width()).arg(size.px.height());
    texts += tr("Own size");
    m_sizes = new QComboBox(this);
    m_sizes->addItems(texts);
    form.addRow(tr("Si&ze"), m_sizes);
    connect(m_sizes, &QComboBox::activated, this, &PictureDialog::chooseSize);
    const auto side = [&](const QString& label, bool isWidth) {
        auto* box = new NumberSpinBox(tr("px"), this);
        box->setRange(PictureChoice::kLeastPx, PictureChoice::kMostPx);
        box->setAccelerated(true);
        box->setKeyboardTracking(false); // 1 and 19 are no widths while 1920 is typed.
        form.addRow(label, box);
        connect(box, &QSpinBox::valueChanged, this, [this, box, isWidth] { changeSide(*box, isWidth); });
        return box;
    };
    m_width = side(tr("&Width"), true);
    m_height = side(tr("&Height"), false);
    m_keepsShape = new QCheckBox(tr("&Keep the proportion"), this);
    form.addRow(QString(), m_keepsShape);
    connect(m_keepsShape, &QCheckBox::toggled, this,
            [this] { m_widthPerHeight = static_cast<double>(m_width->value()) / m_height->value(); });
}

void PictureDialog::addBackgroundRow(QFormLayout& form)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    m_background = new QComboBox(this);
    m_background->addItems({tr("As in the 3D area"), tr("Transparent"), tr("A colour")});
    m_background->setToolTip(
        tr("PNG and OpenEXR keep what is transparent; a JPEG shows the 3D area's background there."));
    m_colour = new Swatch(Qt::white, tr("Colour of the background"), this);
    m_colour->setCheckable(false);
    row->addWidget(m_background, 1);
    row->addWidget(m_colour);
    auto* label = new QLabel(tr("&Background"), this);
    label->setBuddy(m_background);
    form.addRow(label, row);
    connect(m_background, &QComboBox::currentIndexChanged, this, &PictureDialog::follow);
    connect(m_colour, &Swatch::clicked, this, &PictureDialog::chooseColour);
}

QLayout* PictureDialog::buildSide()
{
    m_preview = new QLabel(this);
    m_preview->setFixedSize(kPreviewPx, kPreviewPx);
    m_preview->setAlignment(Qt::AlignCenter);
    m_preview->setAccessibleName(tr("Preview"));
    m_note = new QLabel(this);
    m_note->setProperty("role", QStringLiteral("dim"));
    m_note->setAlignment(Qt::AlignCenter);
    m_note->setWordWrap(true);
    auto* column = new QVBoxLayout;
    column->setSpacing(metrics::kGap);
    column->addWidget(m_preview);
    column->addWidget(m_note);
    column->addStretch(1);
    return column;
}

void PictureDialog::fill(const PictureChoice& choice)
{
    const QSize px = bounded(choice.isAsView ? m_viewPx : choice.size);
    m_sizes->setCurrentIndex(choice.isAsView ? kAsView : indexOf(px));
    showSize(px);
    m_keepsShape->setChecked(choice.keepsShape);
    m_framing->setCurrentIndex(static_cast<int>(choice.framing));
    m_background->setCurrentIndex(static_cast<int>(choice.background));
    m_colour->setColour(choice.colour);
    const auto samples = std::ranges::find(kSampleCounts, choice.samples);
    m_samples->setCurrentIndex(samples == kSampleCounts.end() ? 1 : static_cast<int>(samples - kSampleCounts.begin()));
    follow();
}

void PictureDialog::showSize(QSize px)
{
    const QSignalBlocker ofWidth(m_width);
    const QSignalBlocker ofHeight(m_height);
    m_width->setValue(px.width());
    m_height->setValue(px.height());
    m_widthPerHeight = static_cast<double>(px.width()) / px.height();
}

void PictureDialog::chooseSize()
{
    const int index = m_sizes->currentIndex();
    if (index == kAsView)
        showSize(m_viewPx);
    else if (index < kOwn)
        showSize(kSizes.at(static_cast<std::size_t>(index - kFirstNamed)).px);
    follow();
    if (index == kOwn) {
        m_width->setFocus();
        m_width->selectAll();
    }
}

void PictureDialog::changeSide(QSpinBox& side, bool isWidth)
{
    if (m_keepsShape->isChecked()) {
        QSpinBox& other = isWidth ? *m_height : *m_width;
        const QSignalBlocker blocker(other);
        other.setValue(
            static_cast<int>(std::lround(isWidth ? side.value() / m_widthPerHeight : side.value() * m_widthPerHeight)));
    }
    m_sizes->setCurrentIndex(indexOf(picturePx()));
    follow();
}

void PictureDialog::setViewPx(QSize px)
{
    if (bounded(px) == m_viewPx)
        return;
    m_viewPx = bounded(px);
    if (m_sizes->currentIndex() == kAsView)
        showSize(m_viewPx);
    follow();
}

void PictureDialog::chooseColour()
{
    const QColor before = m_colour->colour();
    auto* dialog = new QColorDialog(before, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(m_colour->accessibleName());
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    const auto show = [this](const QColor& colour) {
        m_colour->setColour(colour);
        refresh();
    };
    connect(dialog, &QColorDialog::currentColorChanged, this, show);
    connect(dialog, &QColorDialog::rejected, this, [show, before] { show(before); });
    dialog->open();
}

QSize PictureDialog::picturePx() const
{
    return {m_width->value(), m_height->value()};
}

QSize PictureDialog::previewPx() const
{
    return picturePx().scaled(kPreviewPx, kPreviewPx, Qt::KeepAspectRatio).expandedTo({1, 1});
}

PictureChoice PictureDialog::choice() const
{
    return {.isAsView = m_sizes->currentIndex() == kAsView,
            .size = picturePx(),
            .keepsShape = m_keepsShape->isChecked(),
            .framing = static_cast<PictureFraming>(m_framing->currentIndex()),
            .background = static_cast<PictureBackground>(m_background->currentIndex()),
            .colour = m_colour->colour(),
            .samples = kSampleCounts.at(static_cast<std::size_t>(m_samples->currentIndex()))};
}

void PictureDialog::follow()
{
    const QSize px = picturePx();
    const bool mayBeFine = std::max(px.width(), px.height()) <= PictureChoice::kMostFinePx;
    m_samples->setEnabled(mayBeFine);
    m_samples->setToolTip(
        mayBeFine
            ? QString()
            : tr("Pictures of more than %1 pixels a side have one sample a pixel.").arg(PictureChoice::kMostFinePx));
    m_colour->setVisible(static_cast<PictureBackground>(m_background->currentIndex()) == PictureBackground::Colour);
    m_note->setText(tr("%1 × %2 px").arg(px.width()).arg(px.height()));
    refresh();
}

void PictureDialog::refresh()
{
    m_isStale = m_isAsked; // Then the next one is asked for when this one has come.
    if (!m_isAsked)
        m_soon.start();
}

void PictureDialog::showPreview(const QImage& picture)
{
    m_isAsked = false;
    if (picture.isNull())
        m_preview->setText(tr("No preview"));
    else
        m_preview->setPixmap(onSquares(picture));
    if (std::exchange(m_isStale, false))
        m_soon.start();
}

bool PictureDialog::event(QEvent* event)
{
    if (event->type() == QEvent::WindowActivate)
        refresh(); // Hair may have been painted meanwhile.
    return QDialog::event(event);
}

} // namespace hairpaint::view
