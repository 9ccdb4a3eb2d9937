// Makes the renderer, and listens to OpenGL.
#include "tests/rendering/renderer_fixture.h"

namespace hairpaint::testing {

void RendererFixture::initTestCase()
{
    m_gl = std::make_unique<GlTest>();
    QVERIFY2(m_gl->failure().empty(), m_gl->failure().c_str());
    auto renderer = rendering::GlRenderer::create();
    QVERIFY2(renderer.has_value(), renderer.has_value() ? "" : renderer.error().c_str());
    m_renderer = std::move(*renderer);
}

void RendererFixture::cleanup()
{
    const std::string errors = m_gl->takeErrors();
    QVERIFY2(errors.empty(), errors.c_str());
}

void RendererFixture::cleanupTestCase()
{
    m_renderer.reset();
    m_gl.reset();
}

} // namespace hairpaint::testing
