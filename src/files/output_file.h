/// \file output_file.h
/// Output files: the only way in which the program and the scene library write files.
///
/// A regular file is first written under another name in the same folder, and renamed once it is complete: other
/// programs see either the old or the new file. It keeps the permissions of the file that it replaces. Symbolic links
/// are followed. Existing files that are not regular (devices, FIFOs, pipes) are written to directly, and never
/// replaced; so are descriptors of this process, by any of their names (`/dev/stdout`, `/dev/fd/3`), even if they refer
/// to a regular file. `-` is standard output.
#pragma once

#include <cairn/error.h>

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cairn::files {

/// Thrown instead of `Error` if the reader of a pipe has closed it, which is no error to report.
class ReaderGone : public Error {
  public:
    /// `path`: the destination of the output.
    explicit ReaderGone(const std::string& path);
};

/// The destination that a path refers to.
struct Destination {
    enum class Kind {
        file,       ///< A regular file, which need not exist.
        stream,     ///< An existing file of another kind: a device, a FIFO.
        descriptor, ///< A descriptor of this process.
    };
    Kind kind = Kind::file;
    std::filesystem::path path; ///< Of files and streams; for files with the last component resolved if it is a link.
    int descriptor = -1;        ///< The descriptor; 1 is standard output.
};

/// Determines the destination of a path as described above. Throws `Error` (io) if it cannot be written: a folder, a
/// path in a missing folder, a cycle of links, or missing write permission.
Destination destination_of(const std::filesystem::path& path);

/// Whether a path refers to standard output, by any of its names.
bool is_standard_output(const std::filesystem::path& path);

/// The extension in lower case with its dot, which determines the format.
std::string extension_of(const std::filesystem::path& path);

/// The name under which a file is written before it is renamed: in the same folder, so that renaming never crosses file
/// systems, and with the same extension.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// The same for a file that another program may continue if this one ends early (`Appearance::resumable`).
std::filesystem::path unfinished_beside(const std::filesystem::path& path);

/// Renames a complete temporary file, with the permissions of the file that it replaces. Removes the temporary file on
/// failure. Throws `Error` (io). `path` as in `Destination`.
void take_name(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Waits until the names of the files in a folder are on disk. Throws `Error` (io).
void sync_folder(const std::filesystem::path& folder);

/// Creates the parent folder of `path` if it is missing. Throws `Error` (io).
void make_parent_folder(const std::filesystem::path& path);

/// When other programs see a regular file that is being written.
enum class Appearance {
    when_whole, ///< When it is closed; it replaces an existing file of its name.
    /// At once: an existing file is emptied, and receives everything written. For files of which a part is useful, too.
    as_it_grows,
    /// As when_whole, but without `close` the data remains as `unfinished_beside`, for another program to continue.
    resumable,
};

/// A file, or another destination with a name, that is being written.
class OutputFile {
  public:
    /// Throws `Error` (io) if it cannot be opened, or if it is resumable and another program is writing it. Waits for a
    /// reader if it is a FIFO; a caught signal ends the wait. `kept`: for a resumable file, the number of bytes of the
    /// unfinished file to keep as its beginning.
    explicit OutputFile(const std::filesystem::path& path, Appearance appearance = Appearance::when_whole,
                        std::size_t kept = 0);
    /// Without `close`, a regular file that appears when whole remains as it was before.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends bytes. Streams and files that appear as they grow receive them at once, others in larger pieces. Throws
    /// `Error` (io), or `ReaderGone`.
    void write(std::string_view bytes);
    /// Replaces `bytes.size()` bytes at `offset`, counted from the start of the file. Throws `Error`: wrong_state for a
    /// stream, io.
    void overwrite(std::size_t offset, std::string_view bytes);
    /// Waits until all written bytes are on disk. Throws `Error` (io).
    void sync();
    /// Whether the destination is not a regular file, so that written bytes cannot be changed.
    bool is_stream() const noexcept { return to_.kind != Destination::Kind::file; }
    /// Finishes the output: a regular file gets its name. Throws `Error` (io), or `ReaderGone`.
    void close();

  private:
    [[noreturn]] void fail(int error);
    void send(std::string_view bytes);
    void open_unfinished(int flags, std::size_t kept);
    void remove_temporary() const;

    std::filesystem::path path_, temporary_;
    Destination to_;
    Appearance appearance_;
    int file_ = -1;
    std::string waiting_;
};

/// Writes a whole file. Throws `Error` (io), or `ReaderGone`.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Writes to a descriptor of this process, called `name` in messages. Throws `Error` (io), or `ReaderGone`.
void write_descriptor(int descriptor, std::string_view bytes, const std::string& name);

} // namespace cairn::files
