// Lists what a repair could not restore.
#pragma once

#include <QDialog>
#include <QStringList>

namespace hairpaint::app {

/// Modal. A list that scrolls and can be copied from.
class RepairDialog : public QDialog
{
    Q_OBJECT
public:
    /// `path`: of the damaged file. `losses`: a sentence each; none where all is there.
    RepairDialog(const QString& path, const QStringList& losses, QWidget* parent = nullptr);
};

} // namespace hairpaint::app
