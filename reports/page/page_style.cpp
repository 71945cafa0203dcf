// SPDX-License-Identifier: Apache-2.0
#include "page/page_style.hpp"

namespace tribo::report {

const std::string_view page_style =
    R"(:root { color-scheme: light dark; --text: #1a1a1a; --paper: #f6f7f8; --card: #fff;
  --quiet: #4a5056; --line: #c3c8cd; --link: #00579b; --holds: #0b6b3a; --differs: #8a4b00;
  --fails: #b3001b; --measured: #274f8f; --absent: #5a3d8a; --on-badge: #fff; }
@media screen and (prefers-color-scheme: dark) {
  :root { --text: #e6e6e6; --paper: #16191c; --card: #1e2226; --quiet: #b4bac0; --line: #4a5157;
    --link: #7fc4ff; --holds: #7fdba6; --differs: #ffbf69; --fails: #ff9a9a; --measured: #a9c7ff;
    --absent: #cdb5ff; --on-badge: #16191c; }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body { margin: 0; font: 1rem/1.5 system-ui, sans-serif; color: var(--text);
  background: var(--paper); overflow-wrap: break-word; }
.page { margin: 0 auto; padding: 1rem; max-width: 66rem; }
a { color: var(--link); }
a:focus-visible, .scroll:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.skip { position: absolute; left: 1rem; top: -4rem; padding: .6rem 1rem; z-index: 2;
  color: var(--text); background: var(--card); border: 2px solid var(--link); }
.skip:focus { top: 1rem; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: .5rem 0 1rem; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 0 0 .75rem; }
h3 { font-size: 1.05rem; margin: 0 0 .5rem; }
section { margin-top: 2.75rem; }
#verdict { margin-top: 1.5rem; }
p, .verdicts, figcaption { max-width: 48rem; }
nav { margin-top: 1.25rem; }
nav h2 { font-size: 1rem; margin: 0 0 .25rem; }
nav ul { display: flex; flex-wrap: wrap; gap: 0 1.1rem; list-style: none; margin: 0; padding: 0; }
nav a { display: inline-block; padding: .3rem 0; }
.verdicts { list-style: none; margin: 0; padding: 0; }
.verdicts li { display: grid; grid-template-columns: 6rem 1fr; gap: .75rem; padding: .55rem 0;
  border-top: 1px solid var(--line); }
.badge { align-self: start; padding: .05rem .3rem; border-radius: 4px; text-align: center;
  font-size: .85rem; font-weight: 600; color: var(--on-badge); background: var(--measured); }
.badge.holds { background: var(--holds); }
.badge.differs { background: var(--differs); }
.badge.fails { background: var(--fails); }
.badge.absent { background: var(--absent); }
.scroll { overflow: auto; margin-top: 1.25rem; width: fit-content; max-width: 100%;
  background: var(--card); border-radius: 6px; border: 1px solid var(--line); }
.scroll.long { max-height: 36rem; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; }
caption span { display: inline-block; position: sticky; left: 0; padding: .6rem;
  max-width: min(calc(100vw - 4rem), 60rem); }
th, td { padding: .3rem .6rem; text-align: left; vertical-align: top;
  border-top: 1px solid var(--line); }
thead th { vertical-align: bottom; background: var(--card); }
.long thead th { position: sticky; top: 0; }
tbody th { font-weight: 400; }
.number, .word { white-space: nowrap; }
.number { text-align: right; }
thead .number, thead .word { white-space: normal; }
.line { min-width: 11rem; }
.prose { min-width: 27rem; }
.list { min-width: 38rem; }
td.list { font-size: .8rem; }
.note { margin: .5rem 0 0; font-size: .9rem; color: var(--quiet); }
code { font-size: .92em; overflow-wrap: anywhere; }
.word code { overflow-wrap: normal; }
.word wbr, .line wbr { display: none; }
.line code { white-space: nowrap; }
.prose code { font-size: .85em; }
figure { margin: 2rem 0 0; }
.picture { width: auto; background: #fff; }
.picture svg { display: block; width: 100%; min-width: 36rem; height: auto; }
.hint { display: none; margin: .4rem 0 0; font-size: .9rem; color: var(--quiet); }
figcaption { margin-top: .6rem; }
.files { display: block; margin-top: .3rem; font-size: .9rem; color: var(--quiet); }
.index, .data { padding-left: 1.2rem; columns: 18rem; column-gap: 2rem; }
.index li, .data li { break-inside: avoid; }
.undrawn { padding: 2rem; text-align: center; background: var(--card);
  border: 1px solid var(--line); border-radius: 6px; }
@media screen and (max-width: 40rem) {
  h1 { font-size: 1.4rem; }
  .verdicts li { display: block; }
  .badge { display: inline-block; min-width: 5rem; margin: 0 0 .25rem; }
  .badge + span { display: block; }
  .hint { display: block; }
  .line code { white-space: normal; }
  .line wbr { display: inline; }
}
@media screen and (min-width: 80rem) {
  .page { display: grid; grid-template-columns: 13rem minmax(0, 1fr); column-gap: 2.5rem;
    max-width: 84rem; }
  header { grid-column: 2; }
  nav { grid-column: 1; grid-row: 1 / span 2; position: sticky; top: 1rem; align-self: start;
    max-height: calc(100vh - 2rem); overflow-y: auto; }
  nav ul { display: block; }
  main { grid-column: 2; }
}
@media print {
  @page { margin: 14mm; }
  :root { font-size: 9.5pt; --paper: #fff; --on-badge: #000; --holds: #fff; --differs: #fff;
    --fails: #fff; --measured: #fff; --absent: #fff; }
  .page { padding: 0; max-width: none; }
  nav, .skip, .hint { display: none; }
  a { color: inherit; text-decoration: none; }
  section { margin-top: 1.5rem; }
  p, .verdicts, figcaption { max-width: none; }
  .scroll, .scroll.long { overflow: visible; width: auto; max-height: none; border: 0; }
  table { font-size: 7pt; }
  th, td { padding: .1rem .3rem; }
  .number, .word, .line code { white-space: normal; }
  .line wbr { display: inline; }
  .line, .prose, .list { min-width: 0; }
  td.list { font-size: inherit; }
  .long thead th { position: static; }
  caption span { position: static; max-width: none; padding: .3rem 0; }
  .badge { border: 1px solid #000; }
  .picture svg { min-width: 0; width: 125mm; margin: 0 auto; }
  .index { display: none; }
  h2, h3, caption, thead { break-after: avoid; }
  tr, figure, .verdicts li, .scroll:not(.long) { break-inside: avoid; }
})";

}  // namespace tribo::report
