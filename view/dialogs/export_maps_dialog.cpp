// Range, values, tiles, format, depth.
#include "view/dialogs/export_maps_dialog.h"

#include "view/look/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

namespace {

/// "1001, 1002, ... 1014"
QString listed(const model::UvTiles& tiles)
{
    constexpr qsizetype kMost = 3;
    QStringList numbers;
    for (const int number : tiles.numbers())
        numbers.append(QString::number(number));
    const QString last = numbers.size() > kMost ? QStringLiteral(", … ") + numbers.last() : QString();
    return numbers.first(std::min(kMost, numbers.size())).join(QStringLiteral(", ")) + last;
}

} // namespace

ExportMapsDialog::ExportMapsDialog(const MapsToExport& maps, const MapsExportChoice& before, QWidget* parent)
    : QDialog(parent), m_headTiles(maps.tiles)
{
    constexpr int kMargin = 16;
    constexpr int kWidth = 380;
    setWindowTitle(tr("Save maps as images"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(metrics::kPadding);
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_range = addChoice(
        *form, tr("&Maps"),
        {tr("%1 of %2").arg(maps.map, maps.group), tr("All of %1").arg(maps.group), tr("All of every group")});
    m_values = addChoice(*form, tr("&Values"), {tr("In the colours of their scales"), tr("As grey")});
    if (!m_headTiles.isOneMap() && !m_headTiles.shared()) {
        m_tiles = addChoice(*form, tr("UV &tiles"),
                            {tr("Side by side on one image"), tr("An image each: %1").arg(listed(m_headTiles))});
        m_tiles->setCurrentIndex(before.options.tiles ? 1 : 0);
    }
    QStringList formats;
    for (const model::MapImageFormat& format : model::mapImageFormats())
        formats += QString::fromLatin1(format.suffix).toUpper();
    m_format = addChoice(*form, tr("&Format"), formats);
    m_depth = addChoice(*form, tr("&Depth"), {tr("16 bits a channel"), tr("8 bits a channel")});
    layout->addLayout(form);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Choose folder…"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addWidget(buttons);
    setMinimumWidth(kWidth);
    m_range->setCurrentIndex(static_cast<int>(before.range));
    m_values->setCurrentIndex(before.options.grey ? 1 : 0);
    m_format->setCurrentIndex(static_cast<int>(before.options.format - model::mapImageFormats().data()));
    m_depth->setCurrentIndex(before.options.bits > 8 ? 0 : 1);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportMapsDialog::follow);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    follow();
}

QComboBox* ExportMapsDialog::addChoice(QFormLayout& form, const QString& label, const QStringList& texts)
{
    auto* box = new QComboBox(this);
    box->addItems(texts);
    form.addRow(label, box);
    return box;
}

void ExportMapsDialog::follow()
{
    m_depth->setEnabled(choice().options.format->hasDepths);
}

MapsExportChoice ExportMapsDialog::choice() const
{
    return {.range = static_cast<MapRange>(m_range->currentIndex()),
            .options = {.format = &model::mapImageFormats()[static_cast<std::size_t>(m_format->currentIndex())],
                        .bits = m_depth->currentIndex() == 0 ? 16 : 8,
                        .grey = m_values->currentIndex() == 1,
                        .tiles = m_tiles != nullptr && m_tiles->currentIndex() == 1 ? std::optional(m_headTiles)
                                                                                    : std::nullopt}};
}

} // namespace hairpaint::view
