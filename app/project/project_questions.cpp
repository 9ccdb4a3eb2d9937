// Message boxes.
#include "app/project/project_questions.h"

#include <QMessageBox>
#include <QPushButton>
#include <QWidget>

namespace hairpaint::app {

bool ProjectQuestions::mayOpenTwice(const QString& name)
{
    QMessageBox box(QMessageBox::Question, tr("Open project"),
                    tr("'%1' is open in another window. What is saved in one of them would replace what was saved in "
                       "the other.")
                        .arg(name),
                    QMessageBox::Cancel, &m_window);
    const QPushButton* open = box.addButton(tr("&Open anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == open;
}

ProjectQuestions::Unsaved ProjectQuestions::askAboutUnsaved(const QString& name)
{
    const auto answer =
        QMessageBox::question(&m_window, tr("Save changes?"), tr("'%1' has changes that are not saved.").arg(name),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Save      ? Unsaved::Save
           : answer == QMessageBox::Discard ? Unsaved::Discard
                                            : Unsaved::Stay;
}

ProjectQuestions::Outside ProjectQuestions::askAboutOutside(const QString& name)
{
    QMessageBox box(QMessageBox::Warning, tr("Save project"),
                    tr("'%1' was changed by another program since it was opened or saved here. Replacing it would lose "
                       "those changes.")
                        .arg(name),
                    QMessageBox::Cancel, &m_window);
    const QPushButton* other = box.addButton(tr("&Save under another name..."), QMessageBox::AcceptRole);
    const QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace ? Outside::Replace
           : box.clickedButton() == other ? Outside::SaveAs
                                          : Outside::Stop;
}

bool ProjectQuestions::offerAnotherPath(const QString& problem)
{
    QMessageBox box(QMessageBox::Warning, tr("Save project"), problem, QMessageBox::Cancel, &m_window);
    const QPushButton* other = box.addButton(tr("&Save under another name..."), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == other;
}

bool ProjectQuestions::offerRepair(const QString& problem)
{
    QMessageBox box(QMessageBox::Warning, tr("Open project"), problem, QMessageBox::Cancel, &m_window);
    box.setInformativeText(tr("What is left of it can be opened as a new project; the file stays as it is."));
    const QPushButton* repair = box.addButton(tr("&Open what can be read"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == repair;
}

void ProjectQuestions::complain(const QString& message)
{
    QMessageBox::warning(&m_window, tr("Hair Paint"), message);
}

} // namespace hairpaint::app
