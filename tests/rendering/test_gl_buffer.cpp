// Memory of the graphics card: there is as much of it as what is drawn needs, within reason.
#include "tests/rendering/gl_test.h"
#include "tests/support/test_program.h"
#include "view/rendering/gl/gl_objects.h"

#include <QtTest>

#include <array>

using namespace hairpaint;
using namespace hairpaint::testing;

class TestGlBuffer : public QObject
{
    Q_OBJECT
private:
    static constexpr std::size_t kMegabyte = 1U << 20U;
    std::unique_ptr<GlTest> m_gl;

private Q_SLOTS:
    void initTestCase()
    {
        m_gl = std::make_unique<GlTest>();
        QVERIFY2(m_gl->failure().empty(), m_gl->failure().c_str());
    }

    void aBufferGrowsAndGivesBack()
    {
        rendering::Buffer buffer;
        QVERIFY(buffer.reserve(8 * kMegabyte));
        QVERIFY(!buffer.reserve(8 * kMegabyte));
        QVERIFY(!buffer.reserve(3 * kMegabyte)); // Hair that moves needs less than hair at rest.
        QVERIFY(buffer.reserve(64 * kMegabyte));
        QVERIFY(buffer.capacity() >= 64 * kMegabyte);
        QVERIFY(buffer.reserve(8 * kMegabyte));
        QVERIFY(buffer.capacity() >= 8 * kMegabyte && buffer.capacity() < 16 * kMegabyte);
        QVERIFY(!buffer.reserve(0) || buffer.capacity() >= 16);
    }

    void whatIsWrittenAfterwardsIsThere()
    {
        rendering::Buffer buffer;
        std::vector<std::uint32_t> many(16 * kMegabyte / sizeof(std::uint32_t), 7);
        buffer.assign(many.data(), many.size() * sizeof(std::uint32_t));
        const std::array<std::uint32_t, 4> few{1, 2, 3, 4};
        QCOMPARE(buffer.writeChanged(few.data(), sizeof(few), many.data(), many.size() * sizeof(std::uint32_t)),
                 sizeof(few));
        QVERIFY(buffer.capacity() < kMegabyte);
        std::array<std::uint32_t, 4> read{};
        buffer.read(read.data(), sizeof(read));
        QCOMPARE(read, few);
    }
};

HAIRPAINT_TEST(TestGlBuffer, Gui)
#include "test_gl_buffer.moc"
