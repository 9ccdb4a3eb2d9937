// Unit and axis of imported hair.
#include "view/dialogs/hair_import_dialog.h"

#include "view/dialogs/length_units.h"
#include "view/look/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace hairpaint::view {

HairImportDialog::HairImportDialog(const QString& fileName, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Import hair"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(metrics::kPadding);
    auto* title = new QLabel(fileName, this);
    title->setProperty("role", QStringLiteral("title"));
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    layout->addWidget(title);
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_unit = new QComboBox(this);
    m_unit->addItem(tr("Automatic"), 0.0);
    for (const LengthUnit& unit : kLengthUnits)
        m_unit->addItem(titleOf(unit), unit.metres);
    m_axis = new QComboBox(this);
    m_axis->addItem(tr("Automatic"));
    for (const model::UpAxis axis : {model::UpAxis::Y, model::UpAxis::Z})
        m_axis->addItem(titleOf(axis), static_cast<int>(axis));
    form->addRow(tr("One &unit is"), m_unit);
    form->addRow(tr("&Up is"), m_axis);
    layout->addLayout(form);
    auto* remark = new QLabel(tr("Automatic takes what the file says, or else what brings the roots to the head. The "
                                 "hair becomes a new group, with maps to paint on."),
                              this);
    remark->setWordWrap(true);
    layout->addWidget(remark);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addWidget(buttons);
    setMinimumWidth(380);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

model::CurveSpaceChoice HairImportDialog::choice() const
{
    model::CurveSpaceChoice choice;
    if (const double metres = m_unit->currentData().toDouble(); metres > 0.0)
        choice.metresPerUnit = static_cast<float>(metres);
    if (const QVariant axis = m_axis->currentData(); axis.isValid())
        choice.upAxis = static_cast<model::UpAxis>(axis.toInt());
    return choice;
}

} // namespace hairpaint::view
