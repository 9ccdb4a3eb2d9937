// What the program is.
#include "view/dialogs/about_dialog.h"

#include "view/look/resources.h"
#include "view/look/theme.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

namespace hairpaint::view {

namespace {

QLabel* makeText(const QString& text, const char* role, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    if (*role != '\0')
        label->setProperty("role", QLatin1String(role));
    return label;
}

} // namespace

AboutDialog::AboutDialog(const QString& version, const QStringList& libraries, const QString& renderer, QWidget* parent)
    : QDialog(parent)
{
    initResources();
    setWindowTitle(tr("About Hair Paint"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 20, 20, 16);
    layout->setSpacing(metrics::kPadding);
    auto* head = new QHBoxLayout;
    head->setSpacing(16);
    auto* picture = new QLabel(this);
    picture->setPixmap(QIcon(QStringLiteral(":/desktop/hairpaint.svg")).pixmap(QSize(72, 72), devicePixelRatioF()));
    picture->setAccessibleName(tr("The program's picture"));
    head->addWidget(picture, 0, Qt::AlignTop);
    auto* names = new QVBoxLayout;
    names->setSpacing(metrics::kGrid);
    names->addWidget(makeText(tr("Hair Paint"), "title", this));
    names->addWidget(makeText(tr("Version %1").arg(version), "dim", this));
    names->addWidget(makeText(tr("Paint maps over a head and watch the hair grow."), "", this));
    head->addLayout(names, 1);
    layout->addLayout(head);
    layout->addWidget(
        makeText(tr("After “Hair Paint” by B. Hernandez and I. Rudomin, 2004. Free software under the MIT "
                    "licence: use it, change it, pass it on. It comes without any warranty."),
                 "label", this));
    QString facts = tr("Runs on %1").arg(QSysInfo::prettyProductName());
    if (!renderer.isEmpty())
        facts += QLatin1Char('\n') + tr("Drawn by %1").arg(renderer);
    facts += QLatin1Char('\n') + tr("Built with %1").arg(libraries.join(QStringLiteral(", ")));
    QLabel* details = makeText(facts, "dim", this);
    details->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout->addWidget(details);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    constexpr int kWidth = 440;
    setFixedWidth(kWidth);
}

void AboutDialog::showEvent(QShowEvent* event)
{
    // Only now do the labels have their fonts, and wrapped text is as high as they make it.
    layout()->invalidate();
    setFixedHeight(layout()->totalHeightForWidth(width()));
    QDialog::showEvent(event);
}

} // namespace hairpaint::view
