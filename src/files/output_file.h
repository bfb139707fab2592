/// \file output_file.h
/// Output files: the one way in which the program, and the library of scenes, write anything.
///
/// A regular file is written beside its place under another name, and takes its name once it is whole: whoever looks
/// sees the old one or the new one. It keeps the rights of the one that it replaces. Symbolic links are followed. What
/// is there and no regular file (a device, a FIFO, a pipe) is written to as it is, and never replaced; so is a
/// descriptor of this process by any of its names (`/dev/stdout`, `/dev/fd/3`), also where it leads to a regular file.
/// `-` is standard output.
#pragma once

#include <cairn/error.h>

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cairn::files {

/// Thrown instead of `Error` where the reader of a pipe has gone away: nothing is wrong, and nobody is left to be told.
class ReaderGone : public Error {
  public:
    /// `path`: what was written to.
    explicit ReaderGone(const std::string& path);
};

/// What a name stands for.
struct Destination {
    enum class Kind {
        file,       ///< A regular file, or none yet.
        stream,     ///< Something else that is there: a device, a FIFO.
        descriptor, ///< One of this process.
    };
    Kind kind = Kind::file;
    std::filesystem::path path; ///< Of files and streams; of files without links in the last place.
    int descriptor = -1;        ///< Of a descriptor; 1 is standard output.
};

/// Looks up what `path` stands for, as described above. Throws `Error` (io) if nothing can be written there: a folder,
/// a name in a folder that is not there, a link that leads in a circle, something without the right to write.
Destination destination_of(const std::filesystem::path& path);

/// Whether that is standard output, by any of its names.
bool is_standard_output(const std::filesystem::path& path);

/// The extension in lower case, with its dot: what decides the format.
std::string extension_of(const std::filesystem::path& path);

/// Where a file is written before it takes its name: beside it, so that renaming cannot cross a file system, and with
/// the same extension.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// The same, for a file that another program is to go on with if this one ends first (`Appearance::resumable`).
std::filesystem::path unfinished_beside(const std::filesystem::path& path);

/// Gives a finished temporary its name, and the rights of the file that it replaces. Removes it if that fails. Throws
/// `Error` (io). `path` as in `Destination`.
void take_name(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Waits until the disk has the names of what is in a folder. Throws `Error` (io).
void sync_folder(const std::filesystem::path& folder);

/// Makes the folder that `path` lies in, if it is missing. Throws `Error` (io).
void make_parent_folder(const std::filesystem::path& path);

/// When others see a regular file that is written.
enum class Appearance {
    when_whole,  ///< Once it is closed, under its name; it replaces what had that name.
    as_it_grows, ///< At once: it is emptied if it is there, and everything written is in it. For files of which also a
                 ///< part is of use.
    resumable,   ///< As the first, but what is written before stays, as `unfinished_beside`, if this ends without
                 ///< `close`: another program can go on with it.
};

/// A file, or anything else that has a name, being written.
class OutputFile {
  public:
    /// Throws `Error` (io) if it cannot be opened, or is resumable and written by another program now. Waits for a
    /// reader if it is a FIFO; a signal that is caught ends that. `kept`: of what is resumable, so many bytes of what
    /// is there unfinished are the beginning of this.
    explicit OutputFile(const std::filesystem::path& path, Appearance appearance = Appearance::when_whole,
                        std::size_t kept = 0);
    /// Without `close`, a regular file that appears when it is whole is left as it was before.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends. Streams and files that appear as they grow get it at once, others in larger pieces. Throws `Error`
    /// (io), or `ReaderGone`.
    void write(std::string_view bytes);
    /// Replaces `bytes.size()` bytes at `offset`, counted from the start of the file. Throws `Error`: wrong_state if
    /// this is a stream, io.
    void overwrite(std::size_t offset, std::string_view bytes);
    /// Waits until the disk has all that was written. Throws `Error` (io).
    void sync();
    /// Whether this is no regular file, so that nothing written can be changed.
    bool is_stream() const noexcept { return to_.kind != Destination::Kind::file; }
    /// Finishes: a regular file takes its name. Throws `Error` (io), or `ReaderGone`.
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
