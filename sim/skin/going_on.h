// Asking, during long work, whether to go on.
#pragma once

#include <cstddef>
#include <functional>

namespace hairpaint::sim {

/// Asks every few thousand faces (or vertices) and remembers a refusal. One thread.
class GoingOn
{
public:
    static constexpr std::size_t kFacesPerQuestion = 4096;

    /// `ask` returns false to stop; an empty one never does. Called on this thread; must outlive this.
    explicit GoingOn(const std::function<bool()>& ask) : m_ask(ask) {}

    /// After so many faces more: whether to go on. False from the first refusal on.
    [[nodiscard]] bool after(std::size_t faces)
    {
        m_faces += faces;
        if (m_faces >= kFacesPerQuestion) {
            m_faces = 0;
            m_stopped = m_stopped || (m_ask && !m_ask());
        }
        return !m_stopped;
    }
    [[nodiscard]] bool stopped() const { return m_stopped; }

private:
    const std::function<bool()>& m_ask;
    std::size_t m_faces = 0;
    bool m_stopped = false;
};

} // namespace hairpaint::sim
