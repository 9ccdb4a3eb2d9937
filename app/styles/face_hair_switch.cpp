// Painting takes a moment, so it is a job.
#include "app/styles/face_hair_switch.h"

#include "model/document/group_commands.h"
#include "model/growth/face_hair.h"
#include "model/values/sentences.h"

#include <QCoreApplication>
#include <QMessageBox>

#include <algorithm>

namespace hairpaint::app {

bool FaceHairSwitch::exists() const
{
    return std::ranges::any_of(m_session.document().project().groups, model::isFaceHair);
}

bool FaceHairSwitch::shown() const
{
    return std::ranges::any_of(m_session.document().project().groups,
                               [](const model::HairGroup& group) { return group.visible && model::isFaceHair(group); });
}

void FaceHairSwitch::toggle()
{
    using Groups = std::vector<model::HairGroup>;
    m_session.editor().tools().commitStroke();
    model::Document& document = m_session.document();
    if (exists())
        return document.push(showFaceHairCommand(document, !shown()));
    const std::shared_ptr<const model::Head> head = document.committed().head;
    std::optional<model::Result<Groups>> made = m_jobs.await<Groups>(
        {.text = QCoreApplication::translate("FaceHair", "Growing brows and lashes"),
         .whenCancelled = QCoreApplication::translate("FaceHair", "Brows and lashes were not grown: cancelled")},
        [&head](const model::Progress& progress) -> model::Result<Groups> {
            std::optional<Groups> grown = model::faceHair(head, progress);
            return grown ? model::Result<Groups>(std::move(*grown)) : model::cancelled(head->name);
        });
    if (!made)
        return;
    const QString problem = !*made ? made->error().message
                            : (*made)->empty()
                                ? QCoreApplication::translate(
                                      "FaceHair", "Where they grow is not known on this head. Set its landmarks with "
                                                  "File > Replace head > Landmarks.")
                                : QString();
    if (!problem.isEmpty())
        QMessageBox::warning(&m_window, QCoreApplication::translate("FaceHair", "Brows and lashes"), problem);
    else
        document.push(addFaceHairCommand(document, std::move(**made)));
}

model::Result<std::optional<model::HairGroup>> growHair(Jobs& jobs, const model::HairKind& kind,
                                                        const std::shared_ptr<const model::Head>& head)
{
    using Grown = std::optional<model::HairGroup>;
    const std::optional<model::Result<Grown>> made =
        jobs.await<Grown>({.text = QCoreApplication::translate("FaceHair", "Growing hair"),
                           .whenCancelled = QCoreApplication::translate("FaceHair", "No group was added: cancelled")},
                          [&](const model::Progress& progress) -> model::Result<Grown> {
                              bool isStopped = false;
                              Grown grown = model::grownHair(kind, head, [&](double fraction) {
                                  isStopped = !progress(fraction);
                                  return !isStopped;
                              });
                              return isStopped ? model::Result<Grown>(model::cancelled(head->name))
                                               : model::Result<Grown>(std::move(grown));
                          });
    return made ? *made : model::Result<Grown>(model::cancelled(head->name));
}

} // namespace hairpaint::app
