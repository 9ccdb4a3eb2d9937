// What the program is, its version and licence, and the work it builds on.
#pragma once

#include <QDialog>

namespace hairpaint::view {

class AboutDialog : public QDialog
{
    Q_OBJECT
public:
    /// `libraries`: each with its version. `renderer`: what draws the 3D area; left out where empty.
    AboutDialog(const QString& version, const QStringList& libraries, const QString& renderer = {},
                QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;
};

} // namespace hairpaint::view
