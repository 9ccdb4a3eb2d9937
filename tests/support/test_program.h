// Many tests in one program: each file of tests makes itself known here, and one is run at a time, by its name.
#pragma once

#include <QObject>

#include <memory>

namespace hairpaint::test {

/// What the program has running while the tests of a class do.
enum class Application
{
    None,
    Core,
    Gui,
    Widgets
};

using MakeTest = std::unique_ptr<QObject> (*)();

/// What a class wants done before there is an application, as with QTEST_MAIN: its static initMain(), if it has one.
template<typename Test>
void prepare()
{
    if constexpr (requires { Test::initMain(); })
        Test::initMain();
}

/// Called before main() by HAIRPAINT_TEST. `file`: test_NAME.cpp, whose tests are run by `PROGRAM NAME [QtTest's
/// options]`.
bool registerTest(const char* file, Application application, void (*prepare)(), MakeTest make);

} // namespace hairpaint::test

#define HAIRPAINT_TEST_NAME(name, number) HAIRPAINT_TEST_NAME_OF(name, number)
#define HAIRPAINT_TEST_NAME_OF(name, number) name##number

/// Instead of QTEST_MAIN, with the application that the class needs.
#define HAIRPAINT_TEST(Class, application)                                                                             \
    [[maybe_unused]] static const bool HAIRPAINT_TEST_NAME(isRegistered, __COUNTER__) = hairpaint::test::registerTest( \
        __FILE__, hairpaint::test::Application::application, hairpaint::test::prepare<Class>,                          \
        []() -> std::unique_ptr<QObject> { return std::make_unique<Class>(); });
