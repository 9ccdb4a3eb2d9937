// A list with pictures and three answers.
#include "app/recovery/recovery_dialog.h"

#include "model/values/sentences.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hairpaint::app {

namespace {

constexpr QSize kPicture(96, 96);
constexpr int kSpacing = 12;
constexpr int kWidth = 520;
constexpr int kMostShown = 4;

/// The same picture where the row is chosen, which would tint it.
QIcon iconOf(const QPixmap& picture)
{
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);
    return icon;
}

QString dayOf(const QDateTime& time)
{
    const QLocale locale;
    const qint64 days = time.date().daysTo(QDate::currentDate());
    const QString clock = locale.toString(time.time(), QLocale::ShortFormat);
    if (days == 0)
        return RecoveryDialog::tr("today, %1").arg(clock);
    if (days == 1)
        return RecoveryDialog::tr("yesterday, %1").arg(clock);
    return locale.toString(time, QLocale::ShortFormat);
}

/// On one line, and no longer than a line can be: journals can hold anything.
QString lineOf(const QString& path)
{
    constexpr qsizetype kMostLetters = 512;
    const QString shown = model::shownPath(path);
    if (shown.size() <= kMostLetters)
        return shown;
    return shown.first(kMostLetters / 2) + QChar(0x2026) + shown.last(kMostLetters / 2);
}

QString textOf(const UnsavedWork& work)
{
    const QString where = work.path.isEmpty() ? RecoveryDialog::tr("Never saved") : lineOf(work.path);
    return lineOf(work.name) + QLatin1Char('\n') +
           RecoveryDialog::tr("Last changed %1, %n step(s) to undo", nullptr, work.steps).arg(dayOf(work.changed)) +
           QLatin1Char('\n') + where;
}

} // namespace

RecoveryDialog::RecoveryDialog(const std::vector<UnsavedWork>& offers, Discard discard, QWidget* parent)
    : QDialog(parent), m_discard(std::move(discard)), m_list(new QListWidget)
{
    setWindowTitle(tr("Unsaved work"));
    auto* text = new QLabel(
        tr("Hair Paint ended before this was saved. Restoring brings it back with its undo steps; the project's file "
           "stays as it is until you save."));
    text->setWordWrap(true);
    m_list->setIconSize(kPicture);
    m_list->setSpacing(kSpacing / 3);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setAccessibleName(windowTitle());
    QPixmap blank(kPicture);
    blank.fill(Qt::transparent);
    for (std::size_t i = 0; i < offers.size(); ++i) {
        auto* item = new QListWidgetItem(iconOf(blank), textOf(offers[i]), m_list);
        item->setData(Qt::UserRole, static_cast<int>(i));
        item->setToolTip(lineOf(offers[i].path));
    }
    m_list->setCurrentRow(0);
    const int rows = std::min(m_list->count(), kMostShown);
    m_list->setFixedHeight(rows * (kPicture.height() + kSpacing) + kSpacing);

    auto* note = new QLabel;
    note->setWordWrap(true);
    note->setObjectName(QStringLiteral("unwritable"));
    const auto stays = std::ranges::find_if(offers, [](const UnsavedWork& one) { return !one.unwritable.isEmpty(); });
    note->setVisible(stays != offers.end());
    if (stays != offers.end())
        note->setText(tr("Nothing can be written to '%1' now, so what lies there can be restored but not removed, and "
                         "is offered again at the next start. Save what you restore.")
                          .arg(lineOf(QFileInfo(stays->unwritable).path())));

    auto* buttons = new QDialogButtonBox;
    QPushButton* restore = buttons->addButton(tr("&Restore"), QDialogButtonBox::AcceptRole);
    QPushButton* later = buttons->addButton(tr("&Not now"), QDialogButtonBox::RejectRole);
    QPushButton* remove = buttons->addButton(tr("&Discard"), QDialogButtonBox::DestructiveRole);
    later->setToolTip(tr("It is offered again at the next start"));
    restore->setDefault(true);
    connect(restore, &QPushButton::clicked, this, &QDialog::accept);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    connect(remove, &QPushButton::clicked, this, &RecoveryDialog::discardChosen);
    connect(m_list, &QListWidget::itemDoubleClicked, this, &QDialog::accept);

    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(kSpacing);
    layout->addWidget(text);
    layout->addWidget(m_list);
    layout->addWidget(note);
    layout->addWidget(buttons);
    setMinimumWidth(kWidth);
    m_list->setFocus();
}

int RecoveryDialog::count() const
{
    return m_list->count();
}

std::size_t RecoveryDialog::chosen() const
{
    return static_cast<std::size_t>(m_list->currentItem()->data(Qt::UserRole).toInt());
}

void RecoveryDialog::setPicture(std::size_t index, const QImage& picture)
{
    for (int row = 0; row < m_list->count(); ++row)
        if (m_list->item(row)->data(Qt::UserRole).toInt() == static_cast<int>(index))
            m_list->item(row)->setIcon(
                iconOf(QPixmap::fromImage(picture.scaled(kPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation))));
}

void RecoveryDialog::discardChosen()
{
    const QString name = m_list->currentItem()->text().section(QLatin1Char('\n'), 0, 0);
    const auto answer = QMessageBox::warning(this, windowTitle(),
                                             tr("Discard the unsaved work on '%1'? This can't be undone.").arg(name),
                                             QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Discard)
        return;
    if (!m_discard(chosen())) {
        QMessageBox::warning(
            this, windowTitle(),
            tr("The unsaved work on '%1' can't be removed: nothing can be written to its folder. It is "
               "offered again at the next start.")
                .arg(name));
        return;
    }
    delete m_list->takeItem(m_list->currentRow());
    if (m_list->count() == 0)
        reject();
}

} // namespace hairpaint::app
