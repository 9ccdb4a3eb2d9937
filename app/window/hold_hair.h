// The command that holds hair as it lies.
#pragma once

#include "app/background/jobs.h"
#include "app/exchange/hair_exchange.h"
#include "app/session/session.h"
#include "model/document/paint_command.h"

#include <QCoreApplication>

namespace hairpaint::app {

/// GUI thread. All that it is made with must outlive it.
class HoldHair
{
    Q_DECLARE_TR_FUNCTIONS(HoldHair)
public:
    HoldHair(Session& session, HairExchange& exchange, Jobs& jobs)
        : m_session(session), m_exchange(exchange), m_jobs(jobs)
    {}

    /// The active group's, inside the selection: its directions and its gel, as one undo step.
    void hold();

private:
    [[nodiscard]] static QString notHeldText();
    [[nodiscard]] std::optional<model::Result<std::vector<model::LayerEdit>>>
    held(const std::shared_ptr<const sim::StrandFrame>& hair);

    Session& m_session;
    HairExchange& m_exchange;
    Jobs& m_jobs;
};

} // namespace hairpaint::app
