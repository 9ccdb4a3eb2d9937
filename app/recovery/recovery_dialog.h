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
    QString name; ///< Name of the project.
    QString path; ///< Path of the project's file; empty where it was never saved.
    QDateTime changed;
    int steps = 0;      ///< Number of undo steps.
    QString unwritable; ///< Folder of its journal, where that can't be removed; else empty.
};

/// Modal. Accepted: one of them is to be restored. Rejected: not now; they are offered again at the next start.
class RecoveryDialog : public QDialog
{
    Q_OBJECT
public:
    /// Discards the offer of that index; returns whether it is gone.
    using Discard = std::function<bool(std::size_t)>;
    /// `discard` is called for each offer that the user discards and confirms.
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
