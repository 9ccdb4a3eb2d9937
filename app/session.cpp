// Connects document, editor and simulation: see the header.
#include "app/session.h"

#include "model/commands/commands.h"
#include "model/map_colours.h"

namespace hairpaint::app {

Session::Session(model::Project project, QObject* parent)
    : QObject(parent), m_document(std::move(project)), m_editor(m_document)
{
    m_inputTimer.setSingleShot(true);
    m_inputTimer.setInterval(0);
    connect(&m_inputTimer, &QTimer::timeout, this, &Session::sendInput);
    connect(&m_document, &model::Document::changed, this, &Session::onChanged);
    m_worker = std::make_unique<sim::SimulationWorker>([this] {
        // One wake-up is enough however many frames are made before the GUI thread gets to it.
        if (!m_frameAnnounced.exchange(true))
            QMetaObject::invokeMethod(this, &Session::takeFrame, Qt::QueuedConnection);
    });
    m_worker->setWind(m_document.project().wind);
    sendInput();
}

Session::~Session()
{
    m_worker.reset();
}

void Session::setPaused(bool paused)
{
    if (paused == m_paused)
        return;
    m_paused = paused;
    m_worker->setPaused(paused);
    Q_EMIT pausedChanged(paused);
}

void Session::resetHair()
{
    m_worker->reset();
}

void Session::puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM)
{
    m_worker->puff(centreWo, velocity, radiusM);
}

void Session::setPose(const sim::HeadPose& pose)
{
    m_worker->setPose(pose);
}

void Session::changeLight(const model::LightSettings& light, bool done)
{
    if (done)
        keep(model::setLightCommand(m_document, light));
    else
        m_document.setPreview({.aspect = model::Change::Aspect::Environment},
                              [light](model::Project& project) { project.light = light; });
}

void Session::changeWind(const sim::Wind& wind, bool done)
{
    if (done)
        keep(model::setWindCommand(m_document, wind));
    else
        m_document.setPreview({.aspect = model::Change::Aspect::Environment},
                              [wind](model::Project& project) { project.wind = wind; });
}

void Session::keep(std::unique_ptr<QUndoCommand> command)
{
    // A command takes the place of its preview, so nobody sees the old values in between.
    if (command == nullptr)
        m_document.clearPreview();
    m_document.push(std::move(command));
}

void Session::toggleWind()
{
    sim::Wind wind = m_document.project().wind;
    wind.enabled = !wind.enabled;
    changeWind(wind, true);
}

void Session::onChanged(const model::Change& change)
{
    using Aspect = model::Change::Aspect;
    if (change.aspect == Aspect::Environment || change.aspect == Aspect::Everything)
        m_worker->setWind(m_document.project().wind);
    // Whatever changed: frames name the document's revision.
    m_inputTimer.start();
}

void Session::lookAt(std::optional<model::MapKind> map)
{
    if (map == m_looked)
        return;
    m_looked = map;
    m_inputTimer.start();
}

void Session::sendInput()
{
    sim::GroomInput input = m_document.groomInput();
    if (m_looked)
        for (sim::GroupInput& group : input.groups)
            if (const auto resolved = m_document.resolved(group.id, *m_looked)) {
                const sim::MapRaster coloured = model::colouredMap(*resolved, model::mapSpec(*m_looked));
                for (const sim::MapRule& rule : sim::kMapRules)
                    if (rule.effect.look)
                        group.maps[rule.slot] = coloured;
            }
    m_worker->setInput(std::move(input));
}

void Session::takeFrame()
{
    m_frameAnnounced = false;
    if (auto frame = m_worker->takeFrame()) {
        m_frame = std::move(frame);
        Q_EMIT frameChanged(m_frame);
    }
}

} // namespace hairpaint::app
