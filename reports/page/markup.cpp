// SPDX-License-Identifier: Apache-2.0
#include "page/markup.hpp"

namespace tribo::report {
namespace {

std::string html_sign(char sign) {
  switch (sign) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return {sign};
  }
}

// A long name in code may go on in the next line after these.
std::string html_code_sign(char sign) {
  constexpr std::string_view joints = "./_";
  const bool is_joint = joints.find(sign) != std::string_view::npos;
  return html_sign(sign) + (is_joint ? "<wbr>" : "");
}

std::string markdown_sign(char sign) {
  constexpr std::string_view special = "\\*_[]|#";
  if (special.find(sign) != std::string_view::npos) return {'\\', sign};
  return sign == '"' ? "\"" : html_sign(sign);
}

// Switches between an opening and a closing text.
class Toggle {
 public:
  Toggle(std::string_view open, std::string_view close) : open_(open), close_(close) {}
  std::string_view next() {
    inside_ = !inside_;
    return inside_ ? open_ : close_;
  }
  bool inside() const { return inside_; }
  std::string_view end() const { return inside_ ? close_ : ""; }

 private:
  std::string_view open_, close_;
  bool inside_ = false;
};

struct Dialect {
  Toggle code, subscript, superscript;
  std::string (*sign)(char);
  std::string (*code_sign)(char);
};

std::string render(std::string_view markup, Dialect dialect) {
  std::string text;
  for (const char sign : markup) {
    if (sign == '`')
      text += dialect.code.next();
    else if (dialect.code.inside())
      text += dialect.code_sign(sign);
    else if (sign == '~')
      text += dialect.subscript.next();
    else if (sign == '^')
      text += dialect.superscript.next();
    else
      text += dialect.sign(sign);
  }
  // Markup that is still open is closed here; otherwise it would cover the text that follows.
  for (const Toggle* toggle : {&dialect.code, &dialect.subscript, &dialect.superscript})
    text += toggle->end();
  return text;
}

std::string itself(char sign) { return {sign}; }

}  // namespace

std::string to_html(std::string_view markup) {
  return render(
      markup,
      {{"<code>", "</code>"}, {"<sub>", "</sub>"}, {"<sup>", "</sup>"}, html_sign, html_code_sign});
}

std::string to_markdown(std::string_view markup) {
  return render(markup,
                {{"`", "`"}, {"<sub>", "</sub>"}, {"<sup>", "</sup>"}, markdown_sign, itself});
}

std::string to_plain(std::string_view markup) {
  return render(markup, {{"", ""}, {"_", ""}, {"^", ""}, itself, itself});
}

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char sign : text) escaped += html_sign(sign);
  return escaped;
}

}  // namespace tribo::report
