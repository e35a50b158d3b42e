// What stands beside the picture of every page: a legend whose rows switch layers, a choice of lights, keys.
//
// picture: what the page's own script does: changed() after a switch, reset(), turn(right, up) by steps of an arrow key,
// zoom(factor). Returns isOn(layer, light): whether what has these two marks is to be seen; an empty mark suits all.
function gnomonPanel(data, picture) {
  "use strict";
  const off = new Set();
  let light = data.lights.length ? data.lights[0] : "";

  function css(color) {
    return "rgb(" + color.map(function (c) { return Math.round(255 * c); }).join(",") + ")";
  }
  function isOn(layer, ofLight) {
    return !off.has(layer) && (!ofLight || ofLight === light);
  }

  // --- the legend -----------------------------------------------------------------------------------------------------

  function addRow(entry) {
    const line = document.createElement("li");
    const button = document.createElement("button");
    const mark = document.createElement("span");
    button.type = "button";
    button.setAttribute("aria-pressed", "true");
    button.title = "show or hide";
    mark.className = entry.mark;
    mark.style.background = css(entry.color);
    if (entry.mark !== "filled") mark.style.borderTopColor = css(entry.color);
    button.appendChild(mark);
    button.appendChild(document.createTextNode(entry.text));
    button.addEventListener("click", function () {
      off.has(entry.layer) ? off.delete(entry.layer) : off.add(entry.layer);
      rows.forEach(function (row) { // a scale has several rows
        if (row.layer === entry.layer) row.button.setAttribute("aria-pressed", String(!off.has(entry.layer)));
      });
      picture.changed();
    });
    line.appendChild(button);
    document.getElementById("legend").appendChild(line);
    return {line: line, button: button, layer: entry.layer, light: entry.light};
  }
  const rows = data.legend.map(addRow);
  function showRows() {
    rows.forEach(function (row) { row.line.hidden = Boolean(row.light) && row.light !== light; });
  }

  // --- lights ---------------------------------------------------------------------------------------------------------

  const choices = [];
  function choose(name) {
    light = name;
    choices.forEach(function (choice) { choice.checked = choice.value === name; });
    showRows();
    picture.changed();
  }
  function addChoices() {
    const set = document.createElement("fieldset");
    const title = document.createElement("legend");
    title.textContent = "light";
    set.appendChild(title);
    data.lights.forEach(function (name) {
      const label = document.createElement("label");
      const choice = document.createElement("input");
      choice.type = "radio";
      choice.name = "light";
      choice.value = name;
      choice.checked = name === light;
      choice.addEventListener("change", function () { choose(name); });
      choices.push(choice);
      label.appendChild(choice);
      label.appendChild(document.createTextNode(" " + name));
      set.appendChild(label);
      set.appendChild(document.createElement("br"));
    });
    document.getElementById("lights").appendChild(set);
  }
  if (data.lights.length > 1) addChoices();
  showRows();

  // --- keys -----------------------------------------------------------------------------------------------------------

  const keys = {
    ArrowLeft: function () { picture.turn(-1, 0); },
    ArrowRight: function () { picture.turn(1, 0); },
    ArrowUp: function () { picture.turn(0, 1); },
    ArrowDown: function () { picture.turn(0, -1); },
    "+": function () { picture.zoom(1.1); },
    "=": function () { picture.zoom(1.1); },
    "-": function () { picture.zoom(1 / 1.1); },
    r: function () { picture.reset(); },
    Home: function () { picture.reset(); },
    l: function () { choose(data.lights[(data.lights.indexOf(light) + 1) % data.lights.length]); }
  };
  document.addEventListener("keydown", function (event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (!keys.hasOwnProperty(key) || (key === "l" && data.lights.length < 2)) return;
    if (event.target.tagName === "INPUT" && key.startsWith("Arrow")) return; // these choose a light
    event.preventDefault();
    keys[key]();
  });
  document.getElementById("reset").addEventListener("click", function () { picture.reset(); });
  document.getElementById("keys").textContent = data.keys + (data.lights.length > 1 ? "\nL: next light" : "");

  return {isOn: isOn};
}
