/* The lines of a text, one after the other: from memory, or from a file that is never held as a whole. */
#ifndef FIXCAST_HOST_TEXT_LINES_H
#define FIXCAST_HOST_TEXT_LINES_H

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace host {

enum class LineEnd {
  lf, /* perhaps after a CR */
  any /* LF, CR LF, or CR alone */
};

class TextLines {
public:
  /* Opens a file. Throws UserError "PATH: what is wrong; what to do", next() too. */
  TextLines(const std::string &path, LineEnd end);
  /* A text that outlives this. */
  TextLines(std::string_view text, LineEnd end) : end_(end), at_end_(true), rest_(text) {}

  /* The next line with its end, valid until the next call; false when there is none. What is longer than 128 KiB comes in parts. */
  bool next(std::string_view &line);

  /* What is in memory of the lines to come: of a file the first 64 KiB before the first call. */
  std::string_view ahead() const { return rest_; }

private:
  struct Close {
    void operator()(std::FILE *file) const { (void)std::fclose(file); }
  };

  void read_on();
  std::size_t end_of_line() const;

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  LineEnd end_;
  bool at_end_ = false;
  std::size_t bytes_ = 0;
  std::string buffer_;
  std::string_view rest_;
};

} // namespace host

#endif
