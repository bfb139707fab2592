// Command listeners, and execution of recorded commands.
#include "commands/execute.h"
#include "world/impl.h"

namespace cairn {

namespace {

bool is_untouched(const State& s) {
    return s.steps == 0 && s.bodies.slots.size() == 0 && s.shapes.slots.size() == 0 && s.joints.slots.size() == 0 &&
           s.fields.slots.size() == 0;
}

// The source for `command_name`, which reads no shape or snapshot argument.
class NoSource final : public CommandSource {
  public:
    const Shape& shape(std::uint64_t) override { throw Error(ErrorCode::invalid_file, "command", "", "has no source"); }
    const Snapshot& snapshot(std::uint64_t) override {
        throw Error(ErrorCode::invalid_file, "command", "", "has no source");
    }
};

} // namespace

void World::Impl::require_not_notifying(const char* call) const {
    if (is_notifying)
        throw Error(ErrorCode::wrong_state, call, "", "not allowed while the listener is notified of a change");
}

void World::set_command_listener(std::shared_ptr<CommandListener> listener) {
    impl_->require_idle("World::set_command_listener");
    impl_->require_usable("World::set_command_listener");
    impl_->require_not_notifying("World::set_command_listener");
    impl_->listener = std::move(listener);
    if (!impl_->listener) return;
    try {
        if (is_untouched(impl_->state))
            impl_->notify(commands::world_set_settings, impl_->state.settings);
        else
            impl_->notify(commands::world_restore, save());
    } catch (...) {
        impl_->listener = nullptr;
        throw;
    }
}

void World::execute(std::span<const std::byte> command, CommandSource& source) {
    commands::CommandReader reader(command, impl_->state.bodies.slots.world(), source);
    commands::execute(*this, reader);
}

std::vector<std::byte> encode_shapes(std::span<const Shape> shapes, CommandListener& numbers) {
    std::vector<std::byte> bytes;
    commands::CommandWriter writer(bytes, numbers);
    writer.number(shapes.size());
    for (const Shape& shape : shapes) write(writer, shape);
    return bytes;
}

std::vector<Shape> decode_shapes(std::span<const std::byte> bytes, CommandSource& source) {
    commands::CommandReader reader(bytes, 0, source);
    std::vector<Shape> shapes;
    for (std::size_t left = reader.count(); left > 0; --left) read(reader, shapes.emplace_back());
    reader.finish();
    return shapes;
}

std::string_view command_name(std::span<const std::byte> command) noexcept {
    try {
        NoSource none;
        return commands::name_of(commands::CommandReader(command, 0, none).number());
    } catch (const Error&) {
        return {};
    }
}

} // namespace cairn
