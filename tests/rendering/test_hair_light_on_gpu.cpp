// The light on hair that the shaders compute is that of the kernels, at thousands of random points.
#include "tests/rendering/gl_test.h"
#include "tests/support/test_program.h"
#include "view/rendering/frame_lights.h"
#include "view/rendering/gl/gl_objects.h"
#include "view/rendering/gl/shader_sources.h"
#include "view/rendering/light/hair_light_inl.h"
#include "view/rendering/light/tone_inl.h"

#include <QtTest>

#include <epoxy/gl.h>

#include <random>
#include <string>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::testing;
using namespace hairpaint::rendering;
namespace simd = hairpaint::rendering::HWY_NAMESPACE;

namespace {

/// std430.
struct GpuPoint
{
    glm::vec4 position; ///< w: shine.
    glm::vec4 tangent;  ///< w: variation.
    glm::vec4 colour;   ///< w: roughness.
    glm::vec4 crossed;  ///< Toward key, eye, rim; w: gloss.
};
struct GpuLit
{
    glm::vec4 lit;
    glm::vec4 shown; ///< Its tone.
    glm::vec4 kept;  ///< It, once held and released.
};

constexpr const char* kShader = R"(
layout(local_size_x = 64) in;
struct Point { vec4 position, tangent, colour, crossed; };
struct Lit { vec4 lit, shown, kept; };
layout(std430, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, binding = 1) writeonly buffer Lits { Lit lits[]; };
void main()
{
    uint i = gl_GlobalInvocationID.x;
    Point p = points[i];
    HairPoint point = HairPoint(p.position.xyz, p.tangent.xyz, p.colour.rgb, fibreDepth(p.colour.rgb), p.tangent.w,
                                p.crossed.x, p.crossed.y, p.crossed.z, 1.0 + p.crossed.w, 1.0 + 1.5 * p.crossed.w);
    vec3 lit = hairLight(point, p.position.w, p.colour.w);
    lits[i] = Lit(vec4(lit, 0.0), vec4(toneOf(lit), 0.0), vec4(lightHeld(heldLight(lit)), 0.0));
}
)";

unsigned compiled(std::string& problem)
{
    const std::string text = "#version 430 core\n" + std::string(shaderSource("strand_layout.glsl")) +
                             std::string(shaderSource("common.glsl")) + std::string(shaderSource("environment.glsl")) +
                             std::string(shaderSource("hair_light.glsl")) + kShader;
    const char* start = text.c_str();
    const unsigned program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &start);
    int linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        std::array<char, 2048> log{};
        glGetProgramInfoLog(program, static_cast<int>(log.size()), nullptr, log.data());
        problem = log.data();
    }
    return program;
}

} // namespace

class TestHairLightOnGpu : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_gl = std::make_unique<GlTest>();
        QVERIFY2(m_gl->failure().empty(), m_gl->failure().c_str());
    }

    void shadersAndKernelsAgree_data()
    {
        QTest::addColumn<int>("model");
        QTest::newRow("Marschner") << static_cast<int>(ScatteringModel::Marschner);
        QTest::newRow("Kajiya-Kay") << static_cast<int>(ScatteringModel::KajiyaKay);
        QTest::newRow("illuminated lines") << static_cast<int>(ScatteringModel::IlluminatedLines);
    }
    void shadersAndKernelsAgree()
    {
        QFETCH(int, model);
        std::mt19937 engine(11);
        const auto between = [&](float low, float high) {
            return low + (high - low) * static_cast<float>(engine() % 65536U) / 65535.0F;
        };
        const auto direction = [&] {
            return glm::normalize(glm::vec3(between(-1.0F, 1.0F), between(-1.0F, 1.0F), between(-1.0F, 1.0F)) + 1e-3F);
        };
        FrameConstants constants{};
        constants.eyeWo = glm::vec4(0.2F, 0.1F, 0.6F, 1.0F);
        constants.headWo = glm::vec4(0.01F, -0.02F, 0.0F, 0.09F);
        constants.keyWo = glm::vec4(direction(), static_cast<float>(model));
        constants.keyColour = glm::vec4(1.2F, 1.0F, 0.8F, 0.0F);
        constants.fillWo = glm::vec4(direction(), 0.0F);
        constants.fillColour = glm::vec4(0.3F);
        constants.rimWo = glm::vec4(direction(), 0.0F);
        constants.rimColour = glm::vec4(0.9F);
        for (std::size_t i = 0; i < constants.around.size(); ++i)
            constants.around.at(i) = glm::vec4(irradianceOf(EnvironmentKind::Sunset).at(i), 0.0F);

        constexpr std::size_t kPoints = 8192;
        std::vector<GpuPoint> points(kPoints);
        for (GpuPoint& p : points)
            p = {.position = glm::vec4(direction() * between(0.08F, 0.3F), between(0.0F, 1.0F)),
                 .tangent = glm::vec4(direction(), between(-0.2F, 0.2F)),
                 .colour = {between(0.0F, 1.0F), between(0.0F, 1.0F), between(0.0F, 1.0F), between(0.0F, 1.0F)},
                 .crossed = {between(0.0F, 12.0F), between(0.0F, 12.0F), between(0.0F, 12.0F), between(-0.6F, 1.0F)}};
        std::vector<GpuLit> lits(kPoints);
        Buffer uniforms;
        uniforms.assign(&constants, sizeof(constants));
        uniforms.bindUniform(0);
        Buffer input;
        input.assign(points.data(), points.size() * sizeof(GpuPoint));
        input.bindStorage(0);
        Buffer output;
        output.assign(lits.data(), lits.size() * sizeof(GpuLit));
        output.bindStorage(1);
        std::string problem;
        const unsigned program = compiled(problem);
        QVERIFY2(problem.empty(), problem.c_str());
        glUseProgram(program);
        glDispatchCompute(kPoints / 64, 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        output.read(lits.data(), lits.size() * sizeof(GpuLit));
        glUseProgram(0);
        glDeleteProgram(program);

        float brightest = 0.0F;
        for (std::size_t i = 0; i < kPoints; ++i) {
            const GpuPoint& p = points[i];
            sim::StrandMaterial material;
            material.shine = p.position.w;
            material.roughness = p.colour.w;
            const auto colour = simd::tripleOf<float>(p.colour);
            const auto lit = simd::hairLight(
                hairLighting(constants, material),
                simd::HairPoint<float>{simd::tripleOf<float>(p.position), simd::tripleOf<float>(p.tangent), colour,
                                       simd::fibreDepth(colour), p.tangent.w, p.crossed.x, p.crossed.y, p.crossed.z,
                                       1.0F + p.crossed.w, 1.0F + 1.5F * p.crossed.w});
            const glm::vec3 expected(lit.x, lit.y, lit.z);
            const auto toned = simd::toneOf(lit);
            const glm::vec3 shown(toned.x, toned.y, toned.z);
            for (int c = 0; c < 3; ++c) {
                const float tolerance = 2e-4F + 2e-3F * expected[c];
                QVERIFY2(std::abs(lits[i].lit[c] - expected[c]) < tolerance,
                         qPrintable(QStringLiteral("%1: %2, not %3").arg(i).arg(lits[i].lit[c]).arg(expected[c])));
                QVERIFY(std::abs(lits[i].shown[c] - shown[c]) < tolerance);
                if (std::max({expected.x, expected.y, expected.z}) < kMostLight)
                    QVERIFY(std::abs(lits[i].kept[c] - expected[c]) < 2.0F * tolerance);
                brightest = std::max(brightest, expected[c]);
            }
        }
        QVERIFY(brightest > 0.5F);
        const std::string errors = m_gl->takeErrors();
        QVERIFY2(errors.empty(), errors.c_str());
    }

private:
    std::unique_ptr<GlTest> m_gl;
};

HAIRPAINT_TEST(TestHairLightOnGpu, None)
#include "test_hair_light_on_gpu.moc"
