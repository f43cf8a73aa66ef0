/*
 * Temporary file, then rename (POSIX). No fsync: the promise is about readers and failures of this program,
 * not about power cuts.
 */
#include "atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "scene_file.h"

namespace host {
namespace {

[[noreturn]] void fail_errno(const std::string &path, int error) {
  const char *advice = "try another path";
  switch (error) {
    case ENOENT:
      advice = path.empty() ? "give the file a name" : "create its directory first";
      break;
    case EACCES:
    case EPERM:
    case EROFS:
      advice = "choose a file and a directory that you may write to";
      break;
    case EISDIR:
      advice = "name a file in it";
      break;
    case ENOTDIR:
      advice = "check the directories in the path";
      break;
    case ENAMETOOLONG:
      advice = "choose a shorter name";
      break;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      advice = "free some space or choose another disk";
      break;
  }
  fail_write(path, std::generic_category().message(error), advice);
}

/* Where the bytes shall end up: symbolic links resolved, and surely not a directory or a device. */
std::string find_target(const std::string &path) {
  std::string target = path;
  std::error_code error;
  if (std::filesystem::is_symlink(path, error)) { /* replace what the link names, not the link */
    target = std::filesystem::canonical(path, error).string();
    if (error) {
      fail_write(path, "the symbolic link leads nowhere", "remove the link or create what it names");
    }
  }
  struct stat status {};
  if (stat(target.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) {
      fail_errno(path, EISDIR);
    }
    if (!S_ISREG(status.st_mode)) { /* renaming would replace the device itself */
      fail_write(path, "this is not an ordinary file", "name one that is, or a new one");
    }
    if (access(target.c_str(), W_OK) != 0) {
      fail_errno(path, errno);
    }
  } else if (errno != ENOENT || path.empty()) {
    fail_errno(path, errno);
  }
  return target;
}

/* A file that is removed again unless it gets its final name. */
class Temporary {
public:
  Temporary(const std::string &path, const std::string &target) {
    const std::filesystem::path directory = std::filesystem::path(target).parent_path();
    for (int attempt = 0; file_ < 0; attempt++) {
      /* Without the target's own name: one that is just short enough would become too long. */
      const std::string name = ".fixcast.tmp" + std::to_string(getpid()) + "-" + std::to_string(attempt);
      name_ = (directory / name).string();
      file_ = open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
      if (file_ < 0 && (errno != EEXIST || attempt == 1000)) {
        fail_errno(path, errno);
      }
    }
  }

  ~Temporary() {
    if (file_ >= 0) {
      close(file_);
    }
    if (!renamed_) {
      unlink(name_.c_str());
    }
  }
  Temporary(const Temporary &) = delete;
  Temporary &operator=(const Temporary &) = delete;

  /* This and rename: true, or false with errno. */
  bool write_and_close(const std::string &bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = write(file_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno != EINTR) {
        return false;
      }
      done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    const int file = file_;
    file_ = -1;
    return close(file) == 0;
  }

  bool rename(const std::string &target) {
    renamed_ = std::rename(name_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

private:
  std::string name_;
  int file_ = -1;
  bool renamed_ = false;
};

} // namespace

void fail_write(const std::string &path, const std::string &reason, const std::string &advice) {
  throw UserError(path + ": cannot write: " + reason + "; " + advice);
}

void write_file(const std::string &path, const std::string &bytes) {
  const std::string target = find_target(path);
  Temporary temporary(path, target);
  if (!temporary.write_and_close(bytes) || !temporary.rename(target)) {
    fail_errno(path, errno);
  }
}

} // namespace host
