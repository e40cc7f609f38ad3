// All settings that were used, with a filter; defaults are marked.
import type { App, Section } from "../app";
import { checkbox, element, field, stackedTable } from "../dom";
import type { Setting } from "../format";
import { makeSection, onlyChanged, setVisible } from "../section";
import { typesetUnit } from "../units";

function matches(setting: Setting, wanted: string): boolean {
  const text =
    `${setting.section}.${setting.key} ${setting.value} ${setting.unit} ${setting.meaning}`.toLowerCase();
  return wanted
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

function row(setting: Setting): (Node | string)[] {
  const value = setting.unit ? `${setting.value}\u00a0${typesetUnit(setting.unit)}` : setting.value;
  return [
    element("code", {}, setting.section ? `${setting.section}.${setting.key}` : setting.key),
    element("span", { class: setting.is_default ? "" : "chosen" }, value),
    setting.is_default ? element("span", { class: "default" }, "default") : "given",
    element("span", { class: "meaning" }, setting.meaning),
  ];
}

export function settingsSection(app: App): Section {
  const search = element("input", {
    attributes: { type: "search", placeholder: "key, value or meaning" },
  });
  const content = element("div");
  const count = element("span", { class: "hint", attributes: { role: "status" } });
  let hidesDefaults = false;
  const draw = () => {
    const settings = app.run?.settings ?? [];
    setVisible(section, settings.length > 0);
    const kept = settings.filter(
      (s) => matches(s, search.value.trim()) && !(hidesDefaults && s.is_default),
    );
    count.textContent =
      kept.length === settings.length
        ? `${settings.length} settings`
        : `${kept.length} of ${settings.length} settings`;
    content.replaceChildren(
      stackedTable("Settings used", ["Key", "Value", "From", "Meaning"], kept.map(row)),
    );
  };
  const bar = element(
    "div",
    { class: "controls" },
    field("Filter", search),
    checkbox("only given", false, (now) => {
      hidesDefaults = now;
      draw();
    }),
    count,
  );
  const section = makeSection("settings", "Settings", bar, content);
  search.addEventListener("input", draw);
  const update = onlyChanged(() => app.run?.settings, draw);
  app.on(["data", "run"], update);
  update();
  return section;
}
