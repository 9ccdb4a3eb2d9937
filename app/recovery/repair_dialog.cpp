// A sentence, the list and a button.
#include "app/recovery/repair_dialog.h"

#include "model/values/sentences.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace hairpaint::app {

namespace {

constexpr int kRepairWidth = 560;
constexpr int kListHeight = 240;
constexpr int kRepairSpacing = 12;
constexpr int kRepairMargin = 16;

} // namespace

RepairDialog::RepairDialog(const QString& path, const QStringList& losses, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Repaired project"));
    const QString name = model::shownPath(path);
    auto* text = new QLabel(
        losses.isEmpty()
            ? tr("Everything in '%1' could be read. The damaged file stays as it is; save what was read under another "
                 "name.")
                  .arg(name)
            : tr("What could be read of '%1' is open. The damaged file stays as it is; save what was read under "
                 "another name.\n\nThis was lost:")
                  .arg(name));
    text->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kRepairMargin, kRepairMargin, kRepairMargin, kRepairMargin);
    layout->setSpacing(kRepairSpacing);
    layout->addWidget(text);
    if (!losses.isEmpty()) {
        QString points;
        for (const QString& loss : losses)
            points += (points.isEmpty() ? QString() : QStringLiteral("\n")) + QStringLiteral("•\u00A0") + loss;
        auto* list = new QPlainTextEdit(points);
        list->setReadOnly(true);
        list->setMinimumHeight(kListHeight);
        list->setAccessibleName(tr("What was lost"));
        layout->addWidget(list);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    setMinimumWidth(kRepairWidth);
    buttons->button(QDialogButtonBox::Close)->setFocus();
}

} // namespace hairpaint::app
