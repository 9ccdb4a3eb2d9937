// The options that the table of export formats names, on the command line.
#pragma once

#include "app/cli/command.h"
#include "model/formats/export_request.h"

namespace hairpaint::app {

/// Rows of --cards, --triangles and so on: what asks for a format, and what formats take.
[[nodiscard]] std::vector<CommandOption> formatOptions();
/// What is wanted of the hair for a file of that name, without groups, number of hairs and what the project gives; the
/// problem in words. Without a name it is the first format.
[[nodiscard]] tl::expected<model::ExportRequest, QString> readRequest(const QCommandLineParser& parser,
                                                                      const QString& output);

} // namespace hairpaint::app
