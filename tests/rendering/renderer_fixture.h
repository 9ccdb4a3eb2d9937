// A renderer for each test program of drawing; a complaint of OpenGL fails the test that caused it.
#pragma once

#include "tests/rendering/gl_test.h"
#include "tests/rendering/hand_made_hair.h"

#include <QtTest>

#include <memory>

namespace hairpaint::testing {

class RendererFixture : public QObject
{
    Q_OBJECT
protected:
    std::unique_ptr<GlTest> m_gl;
    std::unique_ptr<rendering::GlRenderer> m_renderer;

    Picture draw(const rendering::Scene& scene, const rendering::Quality& quality = {}, int width = 200,
                 int height = 150)
    {
        return drawn(*m_renderer, scene, quality, width, height);
    }

private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void cleanupTestCase();
};

} // namespace hairpaint::testing
