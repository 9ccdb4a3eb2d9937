// Asks whether to restore or discard work that was not saved when the program ended.
#pragma once

#include <QDateTime>
#include <QDialog>
#include <QImage>
#include <QString>

#include <functional>
#include <vector>

class QListWidget;

namespace hairpaint::app {

/// The unsaved work of one window.
struct UnsavedWork
{
    QString name; ///< Of the project.
    QString path; ///< Of its file; empty where it was never saved.
    QDateTime changed;
    int steps = 0;      ///< Number of undo steps.
    QString unwritable; ///< Its folder, where it can't be removed from there; else empty.
};

/// Modal. Accepted: one of them is to be restored. Rejected: not now; they are offered again at the next start.
class RecoveryDialog : public QDialog
{
    Q_OBJECT
public:
    /// Whether it is gone.
    using Discard = std::function<bool(std::size_t)>;
    /// `discard` is called for each that the user, asked again, wants to be rid of.
    RecoveryDialog(const std::vector<UnsavedWork>& offers, Discard discard, QWidget* parent = nullptr);

    void setPicture(std::size_t index, const QImage& picture);
    [[nodiscard]] int count() const;          ///< Offers that were not discarded.
    [[nodiscard]] std::size_t chosen() const; ///< Index of the offer that is to be restored.

private:
    void discardChosen();

    Discard m_discard;
    QListWidget* m_list = nullptr;
};

} // namespace hairpaint::app
