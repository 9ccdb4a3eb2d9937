// What the user is asked about a project's file.
#pragma once

#include <QCoreApplication>
#include <QString>

class QWidget;

namespace hairpaint::app {

/// Shows message boxes over a window and waits for the answer. `name`: the project's, as the user knows it. GUI thread.
class ProjectQuestions
{
    Q_DECLARE_TR_FUNCTIONS(ProjectQuestions)
public:
    explicit ProjectQuestions(QWidget& window) : m_window(window) {}

    /// Whether to open what another window has open.
    [[nodiscard]] bool mayOpenTwice(const QString& name);
    enum class Unsaved
    {
        Save,
        Discard,
        Stay
    };
    /// Before changes are lost.
    [[nodiscard]] Unsaved askAboutUnsaved(const QString& name);
    enum class Outside
    {
        Replace,
        SaveAs,
        Stop
    };
    /// Before a file that another program has changed is replaced.
    [[nodiscard]] Outside askAboutOutside(const QString& name);
    /// Tells why it was not saved; whether to save under another name.
    [[nodiscard]] bool offerAnotherPath(const QString& problem);
    /// Tells why it was not opened; whether to open what can be read.
    [[nodiscard]] bool offerRepair(const QString& problem);
    void complain(const QString& message);

private:
    QWidget& m_window;
};

} // namespace hairpaint::app
