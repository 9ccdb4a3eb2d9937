// Two timers and a job.
#include "app/session/freed_memory.h"

#include "app/session/large_memory.h"
#include "model/document/document.h"

namespace hairpaint::app {

namespace {

constexpr int kRestMs = 3000;
constexpr int kLongMs = 30'000;

} // namespace

FreedMemory::FreedMemory(const model::Document& document, Jobs& jobs, QObject* parent) : QObject(parent), m_jobs(jobs)
{
    for (QTimer* timer : {&m_rested, &m_long}) {
        timer->setSingleShot(true);
        connect(timer, &QTimer::timeout, this, &FreedMemory::giveBack);
    }
    m_rested.setInterval(kRestMs);
    m_long.setInterval(kLongMs);
    connect(&document, &model::Document::changed, this, &FreedMemory::onChanged);
}

void FreedMemory::onChanged()
{
    m_rested.start();
    if (!m_long.isActive())
        m_long.start();
}

void FreedMemory::giveBack()
{
    m_rested.stop();
    m_long.stop();
    m_jobs.start<void>(
        {}, // It can't fail.
        [](const model::Progress&) -> model::Result<void> {
            returnFreedMemory();
            return {};
        },
        this, [](const model::Result<void>&) {});
}

} // namespace hairpaint::app
