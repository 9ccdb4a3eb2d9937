<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es">
<context>
    <name>BlendMode</name>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplicar</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Trama</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Oscurecer</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Aclarar</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Sumar</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Restar</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superponer</translation>
    </message>
    <message>
        <source>Soft light</source>
        <translation>Luz suave</translation>
    </message>
    <message>
        <source>Hard light</source>
        <translation>Luz fuerte</translation>
    </message>
</context>
<context>
    <name>BrushDrag</name>
    <message>
        <source>Size %1 cm, hardness %2 %, opacity %3 %</source>
        <translation>Tamaño %1 cm, dureza %2 %, opacidad %3 %</translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste into %1</source>
        <translation>Pegar en %1</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>No file name belongs here</source>
        <translation>Aquí no va ningún nombre de archivo</translation>
    </message>
    <message>
        <source>Exactly one project is wanted</source>
        <translation>Hace falta un proyecto, y solo uno</translation>
    </message>
    <message>
        <source>--%1 takes a number from %2 to %3, not &apos;%4&apos;</source>
        <translation>--%1 admite un número de %2 a %3, no «%4»</translation>
    </message>
    <message>
        <source>makes a project</source>
        <translation>crea un proyecto</translation>
    </message>
    <message>
        <source>tells what a project holds</source>
        <translation>dice qué contiene un proyecto</translation>
    </message>
    <message>
        <source>lists the library of styles</source>
        <translation>lista los peinados de la biblioteca</translation>
    </message>
    <message>
        <source>takes pictures</source>
        <translation>hace imágenes</translation>
    </message>
    <message>
        <source>-o and the project&apos;s name are needed</source>
        <translation>Faltan -o y el nombre del proyecto</translation>
    </message>
    <message>
        <source>--map %1 names no map</source>
        <translation>--map %1 no nombra ningún mapa</translation>
    </message>
    <message>
        <source>--seed takes a whole number up to 2^53</source>
        <translation>--seed admite un número entero de hasta 2^53</translation>
    </message>
    <message>
        <source>--size takes WxH, each from 16 to 8192, not &apos;%1&apos;</source>
        <translation>--size admite ANCHOxALTO, cada uno de 16 a 8192, no «%1»</translation>
    </message>
    <message>
        <source>There is no view &apos;%1&apos;</source>
        <translation>No existe la vista «%1»</translation>
    </message>
    <message>
        <source>--frames takes A-B with B not below A, up to 9999, not &apos;%1&apos;</source>
        <translation>--frames admite A-B, con B no menor que A y hasta 9999, no «%1»</translation>
    </message>
    <message>
        <source>--wind takes X,Y,Z in m/s, each from -30 to 30</source>
        <translation>--wind admite X,Y,Z en m/s, cada uno de -30 a 30</translation>
    </message>
    <message>
        <source>hairpaint [PROJECT]
    opens the editor</source>
        <translation>hairpaint [PROYECTO]
    abre el editor</translation>
    </message>
    <message>
        <source>There is no option %1; %2 --help lists those there are.</source>
        <translation>No existe la opción %1; %2 --help muestra las que hay.</translation>
    </message>
    <message>
        <source>There is no display to open a window on. Without one the command line works: %1 --help</source>
        <translation>No hay pantalla donde abrir una ventana. Sin ella funciona la línea de órdenes: %1 --help</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be overwritten, and it is read from; give another name after -o.</source>
        <translation>«%1» se sobrescribiría, y de ahí se lee; da otro nombre tras -o.</translation>
    </message>
    <message>
        <source>Head: %1, %2 vertices, %3 triangles</source>
        <translation>Cabeza: %1, %2 vértices, %3 triángulos</translation>
    </message>
    <message>
        <source>Group %1: %2 hairs of %3 nodes</source>
        <translation>Grupo %1: %2 pelos de %3 nodos</translation>
    </message>
    <message>
        <source>  %1: %2 x %3, layers: %4</source>
        <translation>  %1: %2 x %3, capas: %4</translation>
    </message>
    <message>
        <source>  Fewer hairs than painted: memory would not hold more</source>
        <translation>  Menos pelos de los pintados: en la memoria no cabrían más</translation>
    </message>
    <message>
        <source>the project to write</source>
        <translation>el proyecto que se escribe</translation>
    </message>
    <message>
        <source>a mesh with uv coordinates instead of the built-in head</source>
        <translation>una malla con coordenadas uv en lugar de la cabeza incluida</translation>
    </message>
    <message>
        <source>a style of the library</source>
        <translation>un estilo de la biblioteca</translation>
    </message>
    <message>
        <source>another drawing of the roots; 1 unless given</source>
        <translation>otro reparto de las raíces; 1 si no se da</translation>
    </message>
    <message>
        <source>limit on hair candidates, over the whole head (was: --max-hairs)</source>
        <translation>límite de candidatos a pelo, en toda la cabeza (antes: --max-hairs)</translation>
    </message>
    <message>
        <source>as JSON, for scripts</source>
        <translation>como JSON, para scripts</translation>
    </message>
    <message>
        <source>how long the hair falls first; 0 is the shape it was given; %1 unless given</source>
        <translation>cuánto cae antes el pelo; 0 es la forma que se le dio; %1 si no se da</translation>
    </message>
    <message>
        <source>only so many of the hairs that are there, an even share</source>
        <translation>solo tantos de los pelos que hay, repartidos por igual</translation>
    </message>
    <message>
        <source>in m/s, instead of the project&apos;s; x to the head&apos;s left, y up, z forward</source>
        <translation>en m/s, en lugar del viento del proyecto; x a la izquierda de la cabeza, y arriba, z adelante</translation>
    </message>
    <message>
        <source>in pixels; 1024x1024 unless given</source>
        <translation>en píxeles; 1024x1024 si no se da</translation>
    </message>
    <message>
        <source>what fills the picture: hair (with the head), head or bust; hair unless given</source>
        <translation>lo que llena la imagen: hair (con la cabeza), head o bust; hair si no se da</translation>
    </message>
    <message>
        <source>a film instead of one picture: FILE.0001.png and on</source>
        <translation>una película en lugar de una imagen: FILE.0001.png y siguientes</translation>
    </message>
    <message>
        <source>frames a second of a film; %1 unless given</source>
        <translation>fotogramas por segundo de una película; %1 si no se da</translation>
    </message>
    <message>
        <source>There is not enough memory for what is wanted of &apos;%1&apos;; give a smaller size or fewer hairs.</source>
        <translation>No hay memoria suficiente para lo que se pide de «%1»; da un tamaño menor o menos pelos.</translation>
    </message>
    <message>
        <source>  Fewer hairs than painted: the limit of %1 candidates for the whole head is reached</source>
        <translation>  Menos pelos de los pintados: se alcanzó el límite de %1 candidatos para toda la cabeza</translation>
    </message>
    <message>
        <source>--fit takes hair, head or bust, not &apos;%1&apos;</source>
        <translation>--fit admite hair, head o bust, no «%1»</translation>
    </message>
    <message>
        <source>hairpaint COMMAND --help
    tells what each option does</source>
        <translation>hairpaint ORDEN --help
    explica cada opción</translation>
    </message>
    <message>
        <source>There is no skin &apos;%1&apos;</source>
        <translation>No hay ninguna piel «%1»</translation>
    </message>
    <message>
        <source>the head moves from frame 0 on, again and again; for films</source>
        <translation>la cabeza se mueve desde el fotograma 0, una y otra vez; para películas</translation>
    </message>
    <message>
        <source>--motion takes nod, shake or turn, not &apos;%1&apos;</source>
        <translation>--motion admite nod, shake o turn, no «%1»</translation>
    </message>
    <message>
        <source>--motion is for films; give --frames too</source>
        <translation>--motion es para películas; dé también --frames</translation>
    </message>
    <message>
        <source>--%1 is given nothing</source>
        <translation>--%1 no recibe nada</translation>
    </message>
    <message>
        <source>--%1 takes a whole number from 1 to %2, not &apos;%3&apos;</source>
        <translation>--%1 toma un número entero de 1 a %2, no «%3»</translation>
    </message>
    <message>
        <source>What was asked for could not be printed; check where standard output leads.</source>
        <translation>No se pudo imprimir lo pedido; compruebe adónde lleva la salida estándar.</translation>
    </message>
    <message>
        <source>the picture to write; as OpenEXR in linear light, alpha in its colours</source>
        <translation>la imagen que se escribe; como OpenEXR en luz lineal, con la alfa en sus colores</translation>
    </message>
    <message>
        <source>instead of a view: degrees from the face toward the head&apos;s left, and upward; the distance in cm, else as --fit asks</source>
        <translation>en lugar de una vista: grados desde el rostro hacia la izquierda de la cabeza, y hacia arriba; la distancia en cm o, si falta, la que pida --fit</translation>
    </message>
    <message>
        <source>1, 4 or 16 a pixel; 4 unless given, and 1 in pictures of more than 4096 pixels a side</source>
        <translation>1, 4 o 16 por píxel; 4 si no se indica, y 1 en imágenes de más de 4096 píxeles por lado</translation>
    </message>
    <message>
        <source>no background: alpha tells what is covered</source>
        <translation>sin fondo: la alfa dice qué está cubierto</translation>
    </message>
    <message>
        <source>--camera takes AZIMUTH,ELEVATION[,DISTANCE], -360 to 360 and -89 to 89 degrees, 5 to 1000 cm, not &apos;%1&apos;</source>
        <translation>--camera admite AZIMUTH,ELEVATION[,DISTANCE], de -360 a 360 y de -89 a 89 grados, de 5 a 1000 cm, no «%1»</translation>
    </message>
    <message>
        <source>--camera and --view exclude each other</source>
        <translation>--camera y --view se excluyen</translation>
    </message>
    <message>
        <source>--samples takes 1, 4 or 16, not &apos;%1&apos;</source>
        <translation>--samples admite 1, 4 o 16, no «%1»</translation>
    </message>
    <message>
        <source>Pictures of more than %1 pixels a side take one sample a pixel, not %2</source>
        <translation>Las imágenes de más de %1 píxeles por lado llevan una muestra por píxel, no %2</translation>
    </message>
    <message>
        <source>-o takes a name that ends in .png or .exr</source>
        <translation>-o admite un nombre que termine en .png o .exr</translation>
    </message>
    <message>
        <source>There is no light &apos;%1&apos;</source>
        <translation>No hay ninguna luz «%1»</translation>
    </message>
    <message>
        <source>only this hair group; may be given again for more</source>
        <translation>solo este grupo de pelo; puede repetirse para más</translation>
    </message>
    <message>
        <source>leaves out points of the hairs that lie so near to the line without them</source>
        <translation>omite los puntos de los pelos que quedan así de cerca de la línea sin ellos</translation>
    </message>
    <message>
        <source>writes every map as an image into that folder</source>
        <translation>escribe cada mapa como imagen en esa carpeta</translation>
    </message>
    <message>
        <source>8 or 16 a channel of png and tif; 16 unless given</source>
        <translation>8 o 16 por canal de png y tif; 16 si no se indica</translation>
    </message>
    <message>
        <source>values as brightness instead of the scales&apos; colours</source>
        <translation>los valores como brillo en lugar de los colores de las escalas</translation>
    </message>
    <message>
        <source>writes the head&apos;s UV layout as a sheet to print and draw on</source>
        <translation>escribe el despliegue UV de la cabeza como hoja para imprimir y dibujar</translation>
    </message>
    <message>
        <source>writes hair, maps and the UV layout for other programs</source>
        <translation>escribe pelo, mapas y el despliegue UV para otros programas</translation>
    </message>
    <message>
        <source>There is no group &apos;%1&apos; in &apos;%2&apos;; &apos;hairpaint info&apos; lists those that are there.</source>
        <translation>No hay ningún grupo «%1» en «%2»; «hairpaint info» muestra los que hay.</translation>
    </message>
    <message>
        <source>-o takes a name that ends in %1</source>
        <translation>-o toma un nombre que termina en %1</translation>
    </message>
    <message>
        <source>--target takes %1, not &apos;%2&apos;</source>
        <translation>--target toma %1, no «%2»</translation>
    </message>
    <message>
        <source>--depth takes 8 or 16, not &apos;%1&apos;</source>
        <translation>--depth toma 8 o 16, no «%1»</translation>
    </message>
    <message>
        <source>Nothing to export is named: give -o, --maps or --uv-sheet</source>
        <translation>No se indica nada que exportar: usa -o, --maps o --uv-sheet</translation>
    </message>
    <message>
        <source>--uv-sheet takes a name that ends in .pdf or .svg</source>
        <translation>--uv-sheet toma un nombre que termina en .pdf o .svg</translation>
    </message>
    <message>
        <source>the head moves once after that, and the hair settles for 1 s more; of a film, from frame 0 on, again and again</source>
        <translation>la cabeza se mueve una vez después, y el pelo se asienta 1 s más; en una película, desde el fotograma 0, una y otra vez</translation>
    </message>
    <message>
        <source>hair in motion, a file a frame: FILE.0001.hair and on</source>
        <translation>pelo en movimiento, un archivo por fotograma: FILE.0001.hair y siguientes</translation>
    </message>
    <message>
        <source>--tolerance and --frames exclude each other</source>
        <translation>--tolerance y --frames se excluyen</translation>
    </message>
    <message>
        <source>writes what can be read of a damaged project, and tells what was lost</source>
        <translation>escribe lo que se puede leer de un proyecto dañado y dice qué se ha perdido</translation>
    </message>
    <message>
        <source>With &apos;%1&apos; the maps would be larger than a project can be; use smaller images, or fewer.</source>
        <translation>Con «%1» los mapas serían mayores de lo que puede ser un proyecto; usa imágenes más pequeñas, o menos.</translation>
    </message>
    <message>
        <source>A picture in linear light has at most %1 million pixels; give a smaller --size, or a name that ends in .png</source>
        <translation>Una imagen en luz lineal tiene como mucho %1 millones de píxeles; indica un --size menor o un nombre que termine en .png</translation>
    </message>
    <message>
        <source>-o takes a name that ends in .hairpaint</source>
        <translation>-o espera un nombre que termine en .hairpaint</translation>
    </message>
    <message>
        <source>Nothing was lost.</source>
        <translation>No se ha perdido nada.</translation>
    </message>
    <message>
        <source>What is wanted of &apos;%1&apos; failed: %2; try again, and report it where it fails again.</source>
        <translation>Falló lo que se pide de «%1»: %2; inténtalo de nuevo e informa de ello si vuelve a fallar.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; goes to the hair group &apos;%2&apos;, and the project has none of that name; name one that it has.</source>
        <translation>«%1» es para el grupo de pelo «%2», y el proyecto no tiene ninguno con ese nombre; indica uno que tenga.</translation>
    </message>
    <message>
        <source>--%1 is for hair; give -o too</source>
        <translation>--%1 es para el pelo; indica también -o</translation>
    </message>
    <message>
        <source>--%1 is for images of maps; give --maps too</source>
        <translation>--%1 es para imágenes de mapas; indica también --maps</translation>
    </message>
    <message>
        <source>as .glb: strips along locks of hair, with textures made from the hair, instead of a ribbon a hair</source>
        <translation>como .glb: tiras a lo largo de los mechones, con texturas hechas del pelo, en vez de una cinta por pelo</translation>
    </message>
    <message>
        <source>joints along the cards&apos; locks, with spring bones (VRMC_springBone) for avatar programs</source>
        <translation>articulaciones a lo largo de los mechones, con huesos de muelle (VRMC_springBone) para programas de avatares</translation>
    </message>
    <message>
        <source>the head&apos;s mesh beside the cards</source>
        <translation>la malla de la cabeza junto a las tarjetas</translation>
    </message>
    <message>
        <source>The arguments hold bytes that are not UTF-8, so no file can be named by them; rename the file first.</source>
        <translation>Los argumentos contienen bytes que no son UTF-8, así que no pueden nombrar ningún archivo; cambia antes el nombre del archivo.</translation>
    </message>
    <message>
        <source>hair of another program as hair groups: its density, length, direction, curl and colours become maps; may be given again for more</source>
        <translation>pelo de otro programa como grupos de pelo: su densidad, longitud, dirección, rizo y colores pasan a ser mapas; puede darse otra vez para más</translation>
    </message>
    <message>
        <source>of those files: m, dm, cm, mm or in; as they say, or as it fits, unless given</source>
        <translation>de esos archivos: m, dm, cm, mm o in; si no se da, lo que ellos digan o lo que encaje</translation>
    </message>
    <message>
        <source>that points up in those files: y or z; as they say, or as it fits, unless given</source>
        <translation>que apunta hacia arriba en esos archivos: y o z; si no se da, lo que ellos digan o lo que encaje</translation>
    </message>
    <message>
        <source>the file to write: curves, USD, lines, ribbons as a mesh, or an avatar: cards on spring bones with the body of a head that came with a skeleton</source>
        <translation>el archivo que se escribe: curvas, USD, líneas, cintas como malla o un avatar: tarjetas sobre huesos de muelle y el cuerpo de una cabeza que llegó con esqueleto</translation>
    </message>
    <message>
        <source>of an avatar, as its file tells; &quot;Unknown&quot; unless given</source>
        <translation>de un avatar, como lo dice su archivo; «Unknown» si no se indica</translation>
    </message>
    <message>
        <source>Hairs: %1 (%2 exported, %3 simulated), seed %4</source>
        <translation>Pelos: %1 (%2 se exportan, %3 simulados), semilla %4</translation>
    </message>
    <message>
        <source>What holds the helper that decodes foreign files, hairpaint-import, on this machine:</source>
        <translation>Lo que contiene al programa auxiliar que descodifica archivos ajenos, hairpaint-import, en este equipo:</translation>
    </message>
    <message>
        <source>  files: Landlock, version %1</source>
        <translation>  archivos: Landlock, versión %1</translation>
    </message>
    <message>
        <source>  files: nothing, it may open those that you may</source>
        <translation>  archivos: nada, puede abrir los mismos que tú</translation>
    </message>
    <message>
        <source>  system calls: seccomp, by a list of those that are allowed</source>
        <translation>  llamadas al sistema: seccomp, con una lista de las permitidas</translation>
    </message>
    <message>
        <source>  system calls: nothing, all can be made</source>
        <translation>  llamadas al sistema: nada, puede hacer todas</translation>
    </message>
    <message>
        <source>  memory: at most %1</source>
        <translation>  memoria: como mucho %1</translation>
    </message>
    <message>
        <source>  memory: nothing, it may take what there is</source>
        <translation>  memoria: nada, puede tomar toda la que haya</translation>
    </message>
    <message>
        <source>The helper that decodes foreign files, hairpaint-import, does not answer; install Hair Paint again.</source>
        <translation>El programa auxiliar que descodifica archivos ajenos, hairpaint-import, no responde; vuelve a instalar Hair Paint.</translation>
    </message>
    <message>
        <source>%1. Usage: %2</source>
        <translation>%1. Uso: %2</translation>
    </message>
    <message>
        <source>--image takes %1, not &apos;%2&apos;</source>
        <translation>--image toma %1, no «%2»</translation>
    </message>
    <message>
        <source>%1 with --%2</source>
        <translation>%1 con --%2</translation>
    </message>
    <message>
        <source>--%1 is not for %2, but for %3</source>
        <translation>--%1 no es para %2, sino para %3</translation>
    </message>
    <message>
        <source>With --%1 -o takes a name that ends in .%2</source>
        <translation>Con --%1, -o toma un nombre que acaba en .%2</translation>
    </message>
    <message>
        <source>--%1 takes %2, not &apos;%3&apos;</source>
        <translation>--%1 toma %2, no «%3»</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>whose unit and axes: %1; %2, in metres with y up, unless given</source>
        <translation>con la unidad y los ejes de quién: %1; %2, en metros con y hacia arriba, si no se indica</translation>
    </message>
    <message>
        <source>of those images: %1; %2 unless given</source>
        <translation>de esas imágenes: %1; %2 si no se indica</translation>
    </message>
    <message>
        <source>%1, instead of the project&apos;s</source>
        <translation>%1, en vez de la del proyecto</translation>
    </message>
    <message>
        <source>at most so many of all cards, %1 to %2; %3 unless given</source>
        <translation>como mucho tantos entre todas las tarjetas, de %1 a %2; %3 si no se indica</translation>
    </message>
    <message>
        <source>a side of the cards&apos; textures: %1; %3 unless given</source>
        <translation>un lado de las texturas de las tarjetas: %1; %3 si no se indica</translation>
    </message>
    <message>
        <source>levels of detail, %1 to %2, each of half the triangles of the one before, with the same textures (MSFT_lod); %3 unless given</source>
        <translation>niveles de detalle, de %1 a %2, cada uno con la mitad de los triángulos del anterior y las mismas texturas (MSFT_lod); %3 si no se indica</translation>
    </message>
    <message>
        <source>Built with %1</source>
        <translation>Construido con %1</translation>
    </message>
    <message>
        <source>This system has no font, so no text can be read; install one, for example Debian&apos;s package fonts-inter.</source>
        <translation>Este sistema no tiene ningún tipo de letra, así que no se puede leer ningún texto; instale uno, por ejemplo el paquete fonts-inter de Debian.</translation>
    </message>
    <message>
        <source>--%1 takes m, dm, cm, mm or in, not &apos;%2&apos;</source>
        <translation>--%1 admite m, dm, cm, mm o in, no «%2»</translation>
    </message>
    <message>
        <source>--%1 takes y or z, not &apos;%2&apos;</source>
        <translation>--%1 admite y o z, no «%2»</translation>
    </message>
    <message>
        <source>--%1 takes x, -x, y, -y, z or -z, not &apos;%2&apos;</source>
        <translation>--%1 admite x, -x, y, -y, z o -z, no «%2»</translation>
    </message>
    <message>
        <source>of that mesh: m, dm, cm, mm or in; as it says, or as a head or a body is tall, unless given</source>
        <translation>de esa malla: m, dm, cm, mm o in; si no se indica, la que diga el archivo o la que corresponda a la altura de una cabeza o un cuerpo</translation>
    </message>
    <message>
        <source>that points up in that mesh: y or z; as it says, or as it is tall, unless given</source>
        <translation>el que apunta hacia arriba en esa malla: y o z; si no se indica, el que diga el archivo o el de su altura</translation>
    </message>
    <message>
        <source>where the face of that mesh looks: x, -x, y, -y, z or -z; z, or -y where z points up, unless given</source>
        <translation>hacia dónde mira la cara de esa malla: x, -x, y, -y, z o -z; si no se indica, z, o -y si z apunta hacia arriba</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds no image that is named after a map, as head_density.png is; rename them or choose another folder.</source>
        <translation>«%1» no contiene ninguna imagen con el nombre de un mapa, como head_density.png; cambia sus nombres o elige otra carpeta.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln strands left out, which are broken</source>
        <translation>
            <numerusform>%1: se omitió %Ln pelo dañado</numerusform>
            <numerusform>%1: se omitieron %Ln pelos dañados</numerusform>
        </translation>
    </message>
    <message>
        <source>each image of it as the map that its name tells: Scalp-density.png, head_length.0001.exr</source>
        <translation>cada imagen de esa carpeta como el mapa que dice su nombre: Scalp-density.png, head_length.0001.exr</translation>
    </message>
    <message>
        <source>a part of that mesh, or its material, that comes in; all unless given; may be given again for more</source>
        <translation>una parte de esa malla, o su material, que entra; todas si no se indica; puede repetirse para más</translation>
    </message>
    <message>
        <source>a part that hair grows on; that with the scalp unless given; may be given again for more</source>
        <translation>una parte en la que crece pelo; la del cuero cabelludo si no se indica; puede repetirse para más</translation>
    </message>
    <message>
        <source>a uv layout made anew, in which no two points share a texel</source>
        <translation>un despliegue uv hecho de nuevo, en el que no hay dos puntos que compartan un téxel</translation>
    </message>
    <message>
        <source>The head of &apos;%1&apos; has no picture of its own; choose another --skin.</source>
        <translation>La cabeza de «%1» no tiene imagen propia; elige otro --skin.</translation>
    </message>
    <message>
        <source>an image as a map: a grey one by its brightness, one in colours by the scale of the map; with :grey by its brightness in any case; IMAGE.&lt;UDIM&gt;.png takes an image for each uv tile</source>
        <translation>una imagen como mapa: si es gris, por su brillo; si tiene colores, por la escala del mapa; con :grey, siempre por su brillo; IMAGE.&lt;UDIM&gt;.png toma una imagen por cada mosaico uv</translation>
    </message>
    <message>
        <source>an image for each uv tile of the head, in its own layout: Scalp-density.1001.png</source>
        <translation>una imagen por cada mosaico uv de la cabeza, en su propio despliegue: Scalp-density.1001.png</translation>
    </message>
    <message>
        <source>%1: its head has one uv tile, so each map is one image, numbered 1001; where an earlier version laid several tiles side by side, import that head anew</source>
        <translation>%1: su cabeza tiene un solo mosaico uv, así que cada mapa es una imagen, con el número 1001; si una versión anterior puso varios mosaicos uno junto a otro, importa esa cabeza de nuevo</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Add group &quot;%1&quot;</source>
        <translation>Añadir grupo «%1»</translation>
    </message>
    <message>
        <source>Remove group &quot;%1&quot;</source>
        <translation>Quitar grupo «%1»</translation>
    </message>
    <message>
        <source>Rename group &quot;%1&quot;</source>
        <translation>Renombrar grupo «%1»</translation>
    </message>
    <message>
        <source>Show group &quot;%1&quot;</source>
        <translation>Mostrar grupo «%1»</translation>
    </message>
    <message>
        <source>Hide group &quot;%1&quot;</source>
        <translation>Ocultar grupo «%1»</translation>
    </message>
    <message>
        <source>Add layer to %1</source>
        <translation>Añadir capa a %1</translation>
    </message>
    <message>
        <source>Remove layer &quot;%1&quot;</source>
        <translation>Quitar capa «%1»</translation>
    </message>
    <message>
        <source>Move layer &quot;%1&quot;</source>
        <translation>Mover capa «%1»</translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation>Cambiar el viento</translation>
    </message>
    <message>
        <source>Change light</source>
        <translation>Cambiar la luz</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Cambiar el fondo</translation>
    </message>
    <message>
        <source>Change head</source>
        <translation>Cambiar la cabeza</translation>
    </message>
    <message>
        <source>Move group &quot;%1&quot;</source>
        <translation>Mover grupo «%1»</translation>
    </message>
    <message>
        <source>Resize %1 to %2 × %2</source>
        <translation>Cambiar %1 a %2 × %2</translation>
    </message>
    <message>
        <source>Change skin tone</source>
        <translation>Cambiar el tono de piel</translation>
    </message>
    <message>
        <source>Add brows and lashes</source>
        <translation>Añadir cejas y pestañas</translation>
    </message>
    <message>
        <source>Show brows and lashes</source>
        <translation>Mostrar cejas y pestañas</translation>
    </message>
    <message>
        <source>Hide brows and lashes</source>
        <translation>Ocultar cejas y pestañas</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
</context>
<context>
    <name>ContentBudget</name>
    <message>
        <source>A project holds at most %1 groups, %2 layers in a map and %3 layers in all: remove some first.</source>
        <translation>Un proyecto contiene como máximo %1 grupos, %2 capas por mapa y %3 capas en total: elimina antes algunas.</translation>
    </message>
    <message>
        <source>The project&apos;s maps would be larger than a project can be (%1 MiB painted): use fewer layers or smaller maps.</source>
        <translation>Los mapas del proyecto serían mayores de lo que un proyecto puede ser (%1 MiB pintados): usa menos capas o mapas más pequeños.</translation>
    </message>
</context>
<context>
    <name>CutDialog</name>
    <message>
        <source>Trim</source>
        <translation>Recortar</translation>
    </message>
    <message>
        <source>All hair of “%1” becomes shorter by as much; what is shorter than hair may become stays as it is.</source>
        <translation>Todo el pelo de «%1» se acorta lo mismo; lo que ya es más corto que lo permitido queda como está.</translation>
    </message>
    <message>
        <source>Trim hair</source>
        <translation>Recortar el pelo</translation>
    </message>
    <message>
        <source>Cut to a level</source>
        <translation>Cortar a un nivel</translation>
    </message>
    <message>
        <source>Each hair of “%1” that hangs lower ends there, as it lies now.</source>
        <translation>Cada pelo de «%1» que cuelga más abajo termina ahí, tal como cae ahora.</translation>
    </message>
    <message>
        <source>Cut hair to a level</source>
        <translation>Cortar el pelo a un nivel</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Hair of “%1” is cut by its distance from the crown; what is shorter stays as it is.</source>
        <translation>El pelo de «%1» se corta según su distancia a la coronilla; lo más corto queda como está.</translation>
    </message>
    <message>
        <source>Cut layers</source>
        <translation>Cortar en capas</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>Hair of “%1” becomes shorter from the top down to the skin at the sides and the nape; what is shorter stays as it is.</source>
        <translation>El pelo de «%1» se acorta desde arriba hasta la piel en los lados y la nuca; lo más corto queda como está.</translation>
    </message>
    <message>
        <source>Cut a fade</source>
        <translation>Cortar un degradado</translation>
    </message>
</context>
<context>
    <name>Drop</name>
    <message>
        <source>Let go to open the project</source>
        <translation>Suelta para abrir el proyecto</translation>
    </message>
    <message>
        <source>Let go to apply the style</source>
        <translation>Suelta para aplicar el peinado</translation>
    </message>
    <message>
        <source>Let go to import the head</source>
        <translation>Suelta para importar la cabeza</translation>
    </message>
    <message>
        <source>Let go to load the image into %1</source>
        <translation>Suelta para cargar la imagen en %1</translation>
    </message>
    <message>
        <source>Only an address was dropped: copy the picture itself, and paste it here</source>
        <translation>Solo has soltado una dirección: copia la imagen misma y pégala aquí</translation>
    </message>
    <message>
        <source>Let go to import the hair</source>
        <translation>Suelta para importar el pelo</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>Any program: metres, y up</source>
        <translation>Cualquier programa: metros, y hacia arriba</translation>
    </message>
    <message>
        <source>Hair curves</source>
        <translation>Curvas de pelo</translation>
    </message>
    <message>
        <source>Strands with width, transparency and colour, small and quickly read.</source>
        <translation>Pelos con grosor, transparencia y color, en un archivo pequeño y rápido de leer.</translation>
    </message>
    <message>
        <source>USD text</source>
        <translation>USD de texto</translation>
    </message>
    <message>
        <source>Strands and guides for Unreal, Houdini, Maya and Blender 4.</source>
        <translation>Pelos y guías para Unreal, Houdini, Maya y Blender 4.</translation>
    </message>
    <message>
        <source>USD archive</source>
        <translation>USD empaquetado</translation>
    </message>
    <message>
        <source>The same as USD text, in one archive.</source>
        <translation>Lo mismo que el USD de texto, en un paquete.</translation>
    </message>
    <message>
        <source>OBJ lines</source>
        <translation>Líneas OBJ</translation>
    </message>
    <message>
        <source>Lines that nearly every program reads; without widths.</source>
        <translation>Líneas que lee casi cualquier programa; sin grosores.</translation>
    </message>
    <message>
        <source>glTF ribbons</source>
        <translation>Cintas glTF</translation>
    </message>
    <message>
        <source>A flat ribbon a strand, as a mesh for engines and the web. Fewer hairs are wider, so that they cover as much.</source>
        <translation>Una cinta plana por pelo, como malla para motores y la web. Cuantos menos pelos, más anchos, para que cubran lo mismo.</translation>
    </message>
    <message>
        <source>glTF cards</source>
        <translation>Tarjetas glTF</translation>
    </message>
    <message>
        <source>Strips along locks of hair with textures made from the hair, for games and avatars; further textures lie beside the file.</source>
        <translation>Tiras a lo largo de los mechones con texturas hechas del pelo, para juegos y avatares; hay más texturas junto al archivo.</translation>
    </message>
    <message>
        <source>VRM avatar</source>
        <translation>Avatar VRM</translation>
    </message>
    <message>
        <source>Cards on spring bones with the whole body, where the head came with a skeleton; for avatar programs, virtual worlds and the web (VRM 1.0).</source>
        <translation>Tarjetas sobre huesos de muelle y todo el cuerpo, si la cabeza llegó con esqueleto; para programas de avatares, mundos virtuales y la web (VRM 1.0).</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Leaves out points of the hairs that lie so near to the line without them; with 0 all points are kept.</source>
        <translation>Omite los puntos de los pelos que quedan así de cerca de la línea sin ellos; con 0 se conservan todos.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>At most so many of all cards together: 2,000 to 8,000 for phones and avatars, 10,000 to 20,000 for consoles and PCs.</source>
        <translation>Como mucho tantos entre todas las tarjetas: de 2000 a 8000 para teléfonos y avatares, de 10 000 a 20 000 para consolas y ordenadores.</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtura</translation>
    </message>
    <message>
        <source>%1 × %1 pixels</source>
        <translation>%1 × %1 píxeles</translation>
    </message>
    <message>
        <source>&amp;Levels of detail</source>
        <translation>&amp;Niveles de detalle</translation>
    </message>
    <message>
        <source>Each further one has half the triangles of the one before and shows the same texture; engines take it for hair that is far away.</source>
        <translation>Cada uno más tiene la mitad de los triángulos del anterior y muestra la misma textura; los motores lo usan para el pelo que está lejos.</translation>
    </message>
    <message>
        <source>Spring &amp;bones</source>
        <translation>Hue&amp;sos de muelle</translation>
    </message>
    <message>
        <source>Joints along the locks, so that avatar programs let the hair swing.</source>
        <translation>Articulaciones a lo largo de los mechones, para que los programas de avatares dejen que el pelo se balancee.</translation>
    </message>
    <message>
        <source>With the &amp;head</source>
        <translation>Con la &amp;cabeza</translation>
    </message>
    <message>
        <source>The head&apos;s mesh goes into the same file.</source>
        <translation>La malla de la cabeza va en el mismo archivo.</translation>
    </message>
    <message>
        <source>&amp;Author</source>
        <translation>&amp;Autor</translation>
    </message>
    <message>
        <source>Whom the avatar&apos;s file names as its author. Others may use it only as the author allows.</source>
        <translation>A quien el archivo del avatar nombra como autor. Los demás solo pueden usarlo como el autor permita.</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
</context>
<context>
    <name>FaceHair</name>
    <message>
        <source>Growing brows and lashes</source>
        <translation>Crecen cejas y pestañas</translation>
    </message>
    <message>
        <source>Where they grow is not known on this head. Set its landmarks with File &gt; Replace head &gt; Landmarks.</source>
        <translation>No se sabe dónde crecen en esta cabeza. Sitúe sus puntos de referencia con Archivo &gt; Reemplazar cabeza &gt; Puntos de referencia.</translation>
    </message>
    <message>
        <source>Brows and lashes</source>
        <translation>Cejas y pestañas</translation>
    </message>
    <message>
        <source>Brows and lashes were not grown: cancelled</source>
        <translation>No se crearon cejas ni pestañas: cancelado</translation>
    </message>
    <message>
        <source>Growing hair</source>
        <translation>Haciendo crecer el pelo</translation>
    </message>
    <message>
        <source>No group was added: cancelled</source>
        <translation>No se añadió ningún grupo: cancelado</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>its archive is cut short or broken</source>
        <translation>está incompleto o roto por dentro</translation>
    </message>
    <message>
        <source>it is not a file of Hair Paint; choose another</source>
        <translation>no es un archivo de Hair Paint; elige otro</translation>
    </message>
    <message>
        <source>it holds more than %1 entries</source>
        <translation>contiene más de %1 entradas</translation>
    </message>
    <message>
        <source>one of its entries has an unacceptable name</source>
        <translation>una de sus entradas tiene un nombre inaceptable</translation>
    </message>
    <message>
        <source>it holds two entries named &apos;%1&apos;</source>
        <translation>contiene dos entradas llamadas «%1»</translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is packed in an unacceptable way</source>
        <translation>su entrada «%1» está comprimida de un modo inaceptable</translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is missing</source>
        <translation>falta su entrada «%1»</translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is too large</source>
        <translation>su entrada «%1» es demasiado grande</translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is broken</source>
        <translation>su entrada «%1» está dañada</translation>
    </message>
    <message>
        <source>its head&apos;s mesh is broken</source>
        <translation>la malla de su cabeza está dañada</translation>
    </message>
    <message>
        <source>it holds no hair group, or too many</source>
        <translation>no contiene ningún grupo de pelo, o contiene demasiados</translation>
    </message>
    <message>
        <source>its map &apos;%1&apos; is not known to this one</source>
        <translation>esta versión no conoce su mapa «%1»</translation>
    </message>
    <message>
        <source>its list of groups, maps and layers is broken</source>
        <translation>su lista de grupos, mapas y capas está dañada</translation>
    </message>
    <message>
        <source>it has too many groups or layers; remove some</source>
        <translation>tiene demasiados grupos o capas; quita algunos</translation>
    </message>
    <message>
        <source>its head is %1 m large, and heads of 1 mm to 100 m can be used; choose another unit</source>
        <translation>su cabeza mide %1 m, y se admiten cabezas de 1 mm a 100 m; elige otra unidad</translation>
    </message>
    <message>
        <source>its mesh has no surface; choose another</source>
        <translation>su malla no tiene superficie; elige otra</translation>
    </message>
    <message>
        <source>The image holds no pixels; choose another.</source>
        <translation>La imagen no contiene píxeles; elige otra.</translation>
    </message>
    <message>
        <source>the helper program hairpaint-import could not be started; install Hair Paint again</source>
        <translation>no se pudo iniciar el programa auxiliar hairpaint-import; vuelve a instalar Hair Paint</translation>
    </message>
    <message>
        <source>reading it failed, so it is likely damaged; convert it with another program and try again</source>
        <translation>falló su lectura, así que seguramente está dañado; conviértelo con otro programa e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>it took too long; try a smaller or simpler file</source>
        <translation>tardó demasiado; prueba con un archivo más pequeño o más sencillo</translation>
    </message>
    <message>
        <source>the helper program&apos;s answer made no sense; convert the file with another program and try again</source>
        <translation>la respuesta del programa auxiliar no tenía sentido; convierte el archivo con otro programa e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>it could not be read; check that it is there and may be read</source>
        <translation>no se pudo leer; comprueba que existe y que tienes permiso para leerlo</translation>
    </message>
    <message>
        <source>its format is not known; convert it to PNG (an image) or glTF (a mesh)</source>
        <translation>su formato es desconocido; conviértelo a PNG (una imagen) o a glTF (una malla)</translation>
    </message>
    <message>
        <source>it is damaged or cut short; try another copy of it</source>
        <translation>está dañado o incompleto; prueba con otra copia</translation>
    </message>
    <message>
        <source>it is too large; try one of at most 8192 x 8192 pixels or 2 million vertices</source>
        <translation>es demasiado grande; prueba con uno de 8192 x 8192 píxeles o 2 millones de vértices como mucho</translation>
    </message>
    <message>
        <source>it holds no surface; choose a mesh of triangles or polygons</source>
        <translation>no contiene ninguna superficie; elige una malla de triángulos o polígonos</translation>
    </message>
    <message>
        <source>its mesh has no uv coordinates, which the maps need; unwrap it in a 3D program first</source>
        <translation>su malla no tiene coordenadas UV, y los mapas las necesitan; despliégala antes en un programa 3D</translation>
    </message>
    <message>
        <source>images with this ending can&apos;t be written; use .png, .tif or .exr</source>
        <translation>no se pueden escribir imágenes con esa extensión; usa .png, .tif o .exr</translation>
    </message>
    <message>
        <source>there was not enough memory for it; try a smaller one</source>
        <translation>no hubo memoria suficiente; prueba con uno más pequeño</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in project.json is not what it should be</source>
        <translation>«%1» en project.json no es lo que debería ser</translation>
    </message>
    <message>
        <source>its maps are larger than this program can hold; use fewer layers or smaller maps</source>
        <translation>sus mapas son más grandes de lo que cabe en este programa; usa menos capas o mapas más pequeños</translation>
    </message>
    <message>
        <source>it is a file of another kind (%1); choose another</source>
        <translation>es un archivo de otro tipo (%1); elige otro</translation>
    </message>
    <message>
        <source>its format version is missing</source>
        <translation>falta la versión de su formato</translation>
    </message>
    <message>
        <source>its format is %1, and this Hair Paint reads up to %2</source>
        <translation>su formato es el %1, y este Hair Paint lee hasta el %2</translation>
    </message>
    <message>
        <source>one of its images is broken</source>
        <translation>una de sus imágenes está dañada</translation>
    </message>
    <message>
        <source>one of its images is not %1 x %1 in 16-bit RGBA</source>
        <translation>una de sus imágenes no es RGBA de 16 bits de %1 x %1</translation>
    </message>
    <message>
        <source>its head &apos;%1&apos; is not known to this one</source>
        <translation>esta versión no conoce su cabeza «%1»</translation>
    </message>
    <message>
        <source>its project.json is too large or nested too deep</source>
        <translation>su project.json es demasiado grande o tiene demasiados niveles</translation>
    </message>
    <message>
        <source>its project.json can&apos;t be understood</source>
        <translation>su project.json no se entiende</translation>
    </message>
    <message>
        <source>its way of drawing roots is not known to this one</source>
        <translation>esta versión no conoce su modo de sortear raíces</translation>
    </message>
    <message>
        <source>&apos;%1&apos; can&apos;t be opened: %2; open it with a newer Hair Paint.</source>
        <translation>«%1» no se puede abrir: %2; ábrelo con un Hair Paint más reciente.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; can&apos;t be opened: %2.</source>
        <translation>«%1» no se puede abrir: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2; try an earlier copy of it.</source>
        <translation>«%1» está dañado: %2; prueba con una copia anterior.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; can&apos;t be written: %2.</source>
        <translation>«%1» no se puede escribir: %2.</translation>
    </message>
    <message>
        <source>Working on &apos;%1&apos; was cancelled; nothing has changed.</source>
        <translation>Se canceló el trabajo con «%1»; nada ha cambiado.</translation>
    </message>
    <message>
        <source>there is no such file; check the name and the folder</source>
        <translation>no existe tal archivo; comprueba el nombre y la carpeta</translation>
    </message>
    <message>
        <source>it is a folder; choose a file inside it</source>
        <translation>es una carpeta; elige un archivo de dentro</translation>
    </message>
    <message>
        <source>it is not an ordinary file; choose another</source>
        <translation>no es un archivo corriente; elige otro</translation>
    </message>
    <message>
        <source>it is empty; choose another file</source>
        <translation>está vacío; elige otro archivo</translation>
    </message>
    <message>
        <source>it is larger than %1, the most that is read; choose a smaller file</source>
        <translation>pasa de %1, lo máximo que se lee; elige un archivo más pequeño</translation>
    </message>
    <message>
        <source>%1; check that you may read it</source>
        <translation>%1; comprueba que tienes permiso para leerlo</translation>
    </message>
    <message>
        <source>it is a folder; give the name of a file</source>
        <translation>es una carpeta; da el nombre de un archivo</translation>
    </message>
    <message>
        <source>it is not an ordinary file; choose another name</source>
        <translation>no es un archivo corriente; elige otro nombre</translation>
    </message>
    <message>
        <source>there is no folder &apos;%1&apos;; make it first</source>
        <translation>no existe la carpeta «%1»; créala antes</translation>
    </message>
    <message>
        <source>there is no space left on its disk; make room there and try again</source>
        <translation>no queda espacio en su disco; haz sitio e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>only a part of it could be written; check that its disk has room</source>
        <translation>solo se pudo escribir una parte; comprueba que su disco tiene sitio</translation>
    </message>
    <message>
        <source>its head stands %1 m from the scene&apos;s origin, and 1 km is the most; move it there in a 3D program</source>
        <translation>su cabeza está a %1 m del origen de la escena, y 1 km es lo máximo; muévela allí en un programa 3D</translation>
    </message>
    <message>
        <source>the way it is compressed is not supported; save it as PNG or TIFF in the program that made it, and try again</source>
        <translation>su forma de compresión no se admite; guárdala como PNG o TIFF en el programa que la hizo e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>there is not enough memory for it; close other programs and try again</source>
        <translation>no hay memoria suficiente para ello; cierra otros programas e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>Parting and sweep back</source>
        <translation>Raya y peinado hacia atrás</translation>
    </message>
    <message>
        <source>what it holds is damaged</source>
        <translation>lo que contiene está dañado</translation>
    </message>
    <message>
        <source>an earlier part of it could not be written</source>
        <translation>no se pudo escribir una parte anterior</translation>
    </message>
    <message>
        <source>it would take %1, and %2 is the most; make the hair less dense or less curled, or export fewer hairs</source>
        <translation>ocuparía %1, y lo máximo es %2; haz el pelo menos denso o menos rizado, o exporta menos pelos</translation>
    </message>
    <message>
        <source>Its head is lost; that of a new project takes its place.</source>
        <translation>Se ha perdido su cabeza; en su lugar queda la de un proyecto nuevo.</translation>
    </message>
    <message>
        <source>Its head &apos;%1&apos; is lost; that of a new project takes its place.</source>
        <translation>Se ha perdido su cabeza «%1»; en su lugar queda la de un proyecto nuevo.</translation>
    </message>
    <message>
        <source>Settings of the group &apos;%1&apos; are lost; the usual ones take their place.</source>
        <translation>Se han perdido ajustes del grupo «%1»; en su lugar quedan los habituales.</translation>
    </message>
    <message>
        <source>&apos;%2&apos; of the group &apos;%1&apos; is lost; the usual takes its place.</source>
        <translation>Se ha perdido «%2» del grupo «%1»; en su lugar queda lo habitual.</translation>
    </message>
    <message>
        <source>Group number %1 is lost.</source>
        <translation>Se ha perdido el grupo número %1.</translation>
    </message>
    <message>
        <source>The map &apos;%2&apos; of the group &apos;%1&apos; is lost.</source>
        <translation>Se ha perdido el mapa «%2» del grupo «%1».</translation>
    </message>
    <message>
        <source>Name, order and blending of the layer &apos;%3&apos; of %2 in the group &apos;%1&apos; are lost; its paint is there.</source>
        <translation>Se han perdido el nombre, el orden y la fusión de la capa «%3» de %2 en el grupo «%1»; lo pintado sigue ahí.</translation>
    </message>
    <message>
        <source>The paint of the layer &apos;%3&apos; of %2 in the group &apos;%1&apos; is lost.</source>
        <translation>Se ha perdido lo pintado en la capa «%3» de %2 en el grupo «%1».</translation>
    </message>
    <message>
        <source>The lower %4 % of the paint of the layer &apos;%3&apos; of %2 in the group &apos;%1&apos; are lost.</source>
        <translation>Se ha perdido el %4 % inferior de lo pintado en la capa «%3» de %2 en el grupo «%1».</translation>
    </message>
    <message>
        <source>Its settings don&apos;t agree with their checksum; look over those that are there.</source>
        <translation>Sus ajustes no coinciden con su suma de comprobación; revisa los que hay.</translation>
    </message>
    <message>
        <source>nothing of a project could be found in it; try an earlier copy of it</source>
        <translation>no se ha encontrado en él nada de un proyecto; prueba con una copia anterior</translation>
    </message>
    <message>
        <source>Its background colour is lost; the usual takes its place.</source>
        <translation>Se ha perdido su color de fondo; en su lugar queda el habitual.</translation>
    </message>
    <message>
        <source>Its colliders are lost; the usual ones take their place.</source>
        <translation>Se han perdido sus elipsoides de colisión; en su lugar quedan los habituales.</translation>
    </message>
    <message>
        <source>The name, unit and landmarks of its head are lost; they are guessed anew.</source>
        <translation>Se han perdido el nombre, la unidad y los puntos de referencia de su cabeza; se deducen de nuevo.</translation>
    </message>
    <message>
        <source>Its light is lost; the usual takes its place.</source>
        <translation>Se ha perdido su luz; en su lugar queda la habitual.</translation>
    </message>
    <message>
        <source>Its limit on hair candidates is lost; the usual takes its place.</source>
        <translation>Se ha perdido su límite de candidatos a pelo; en su lugar queda el habitual.</translation>
    </message>
    <message>
        <source>The seed of its roots is lost; the usual takes its place, and each hair stands elsewhere.</source>
        <translation>Se ha perdido la semilla de sus raíces; en su lugar queda la habitual, y cada pelo nace en otro sitio.</translation>
    </message>
    <message>
        <source>Its skin tone is lost; the usual takes its place.</source>
        <translation>Se ha perdido su tono de piel; en su lugar queda el habitual.</translation>
    </message>
    <message>
        <source>Its wind is lost; the usual takes its place.</source>
        <translation>Se ha perdido su viento; en su lugar queda el habitual.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilidad</translation>
    </message>
    <message>
        <source>it can&apos;t take the place of the one before; close what has that open and try again</source>
        <translation>no puede ocupar el lugar del anterior; cierra lo que lo tenga abierto e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>%1; check that you may write there, or choose another place</source>
        <translation>%1; comprueba que puedes escribir ahí o elige otro lugar</translation>
    </message>
    <message>
        <source>the hair has too many points for this format; export fewer hairs</source>
        <translation>el pelo tiene demasiados puntos para este formato; exporta menos pelos</translation>
    </message>
    <message>
        <source>it would be larger than 4 GB; use fewer layers or smaller maps</source>
        <translation>sería mayor de 4 GB; usa menos capas o mapas más pequeños</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos;, which it needs, is missing; put it where it was saved with this one, and try again</source>
        <translation>falta el archivo «%1», que necesita; ponlo donde estaba cuando se guardó con este e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>its hair does not fit on this head; export it in metres with y up, as it stands on a head of this size</source>
        <translation>su pelo no encaja en esta cabeza; expórtalo en metros con la y hacia arriba, tal como está en una cabeza de este tamaño</translation>
    </message>
    <message>
        <source>it holds no USD text; save it with the ending .usda</source>
        <translation>no contiene texto USD; guárdalo con la terminación .usda</translation>
    </message>
    <message>
        <source>hair is read from files that end in %1; choose one of those</source>
        <translation>el pelo se lee de archivos que terminan en %1; elige uno de ellos</translation>
    </message>
    <message>
        <source>it holds no hair; choose another file</source>
        <translation>no contiene pelo; elige otro archivo</translation>
    </message>
    <message>
        <source>its hair is cut short or broken; export it again</source>
        <translation>su pelo está cortado o dañado; expórtalo de nuevo</translation>
    </message>
    <message>
        <source>it is no hair file; choose one that a hair program exported</source>
        <translation>no es un archivo de pelo; elige uno que haya exportado un programa de pelo</translation>
    </message>
    <message>
        <source>its USD text is broken or cut short; export it again</source>
        <translation>su texto USD está dañado o cortado; expórtalo de nuevo</translation>
    </message>
    <message>
        <source>it moves its hair in a way that is not known to this program; apply all transforms and export it again</source>
        <translation>mueve su pelo de un modo que este programa no conoce; aplica todas las transformaciones y expórtalo de nuevo</translation>
    </message>
    <message>
        <source>it is USD in its binary form, which is not read; save it as text, with the ending .usda</source>
        <translation>es USD en su forma binaria, que no se lee; guárdalo como texto, con la terminación .usda</translation>
    </message>
    <message>
        <source>it is no USD text; choose a file that another program saved as .usda</source>
        <translation>no es texto USD; elige un archivo que otro programa haya guardado como .usda</translation>
    </message>
    <message>
        <source>This can be no avatar: %1.</source>
        <translation>Esto no puede ser un avatar: %1.</translation>
    </message>
    <message>
        <source>the head came without a skeleton, and a VRM has a whole body&apos;s; export the hair as .glb with spring bones instead</source>
        <translation>la cabeza llegó sin esqueleto, y un VRM lleva el de un cuerpo entero; exporta el pelo como .glb con huesos de muelle</translation>
    </message>
    <message>
        <source>among the names of the head&apos;s joints these were not found: %1; export the hair as .glb with spring bones instead</source>
        <translation>entre los nombres de las articulaciones de la cabeza faltan estos: %1; exporta el pelo como .glb con huesos de muelle</translation>
    </message>
    <message>
        <source>its disk or network folder does not answer; try again when it does, or use another place</source>
        <translation>su disco o carpeta de red no responde; vuelva a intentarlo cuando lo haga o use otro lugar</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos;, which it needs, lies outside of its folder, where nothing is read; save both into one folder, and try again</source>
        <translation>el archivo «%1», que necesita, está fuera de su carpeta, de donde no se lee nada; guarda ambos en una misma carpeta e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>it is a device, and no file can take its place; choose another name</source>
        <translation>es un dispositivo, y ningún archivo puede ocupar su lugar; elige otro nombre</translation>
    </message>
    <message>
        <source>it is a pipe, and no file can take its place; choose another name</source>
        <translation>es una tubería, y ningún archivo puede ocupar su lugar; elige otro nombre</translation>
    </message>
    <message>
        <source>it is a socket, and no file can take its place; choose another name</source>
        <translation>es un socket, y ningún archivo puede ocupar su lugar; elige otro nombre</translation>
    </message>
    <message>
        <source>Windows takes no file name with one of &lt; &gt; : &quot; / \ | ? *; choose another name</source>
        <translation>Windows no admite nombres de archivo con uno de &lt; &gt; : &quot; / \ | ? *; elige otro nombre</translation>
    </message>
    <message>
        <source>Windows takes no file name that ends with a full stop or a space; choose another name</source>
        <translation>Windows no admite nombres de archivo que acaben en punto o espacio; elige otro nombre</translation>
    </message>
    <message>
        <source>it is a link to a name that is not UTF-8; choose another name</source>
        <translation>es un enlace a un nombre que no es UTF-8; elige otro nombre</translation>
    </message>
    <message>
        <source>it is a link that leads round in a circle; choose another name</source>
        <translation>es un enlace que da vueltas en círculo; elige otro nombre</translation>
    </message>
    <message>
        <source>it leads to a file without a name, which nothing can take the place of; choose another name</source>
        <translation>lleva a un archivo sin nombre, cuyo lugar nada puede ocupar; elige otro nombre</translation>
    </message>
    <message>
        <source>What is worn in the hair is lost.</source>
        <translation>Se ha perdido lo que se lleva en el pelo.</translation>
    </message>
    <message>
        <source>something worn in it is of a kind that is not known to this one</source>
        <translation>esta versión no conoce el tipo de algo que se lleva en él</translation>
    </message>
    <message>
        <source>all its uv coordinates are the same, so there is nothing to paint on; unwrap it in a 3D program first</source>
        <translation>todas sus coordenadas UV son iguales, así que no hay dónde pintar; despliéguelo antes en un programa 3D</translation>
    </message>
    <message>
        <source>its face can&apos;t look along the axis that is up; choose another axis for one of them</source>
        <translation>su cara no puede mirar a lo largo del eje que apunta hacia arriba; elija otro eje para uno de los dos</translation>
    </message>
    <message>
        <source>it asks for the glTF extension &apos;%1&apos;, which is not known here; export it without that extension</source>
        <translation>requiere la extensión de glTF «%1», que aquí no se conoce; expórtelo sin esa extensión</translation>
    </message>
    <message>
        <source>its %1 compression could not be decoded, so it is likely damaged; export it without compression</source>
        <translation>su compresión %1 no se pudo descodificar, así que probablemente está dañado; expórtelo sin compresión</translation>
    </message>
    <message>
        <source>it can&apos;t be read (%1); try another copy of it, or export it once more</source>
        <translation>no se puede leer (%1); pruebe otra copia o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>it holds layers without the picture that they make; save it with “Maximize compatibility” on, or as PNG or TIFF, and try again</source>
        <translation>contiene capas sin la imagen que forman; guárdalo con «Maximizar compatibilidad» activado, o como PNG o TIFF, e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>its hair does not lie on this head in the unit and axis that it is told to have; tell others, or none</source>
        <translation>su pelo no queda sobre esta cabeza con la unidad y el eje que se le indicaron; indica otros, o ninguno</translation>
    </message>
    <message>
        <source>its curves are NURBS, which are not read; export them as basis curves</source>
        <translation>sus curvas son NURBS, que no se leen; expórtalas como curvas de base (BasisCurves)</translation>
    </message>
    <message>
        <source>it has no part &apos;%1&apos;; it has %2</source>
        <translation>no tiene ninguna parte «%1»; tiene %2</translation>
    </message>
    <message>
        <source>its part &apos;%1&apos; has no uv coordinates to paint on; choose another, or a layout of our own</source>
        <translation>su parte «%1» no tiene coordenadas uv en las que pintar; elige otra, o un despliegue propio</translation>
    </message>
    <message>
        <source>hair is to grow on none of its parts; choose one</source>
        <translation>no crece pelo en ninguna de sus partes; elige una</translation>
    </message>
    <message>
        <source>without uv coordinates, so no hair grows there: %1</source>
        <translation>sin coordenadas uv, así que ahí no crece pelo: %1</translation>
    </message>
    <message>
        <source>its uv tiles lie side by side on the maps: 1001, %1</source>
        <translation>sus mosaicos uv están uno junto a otro en los mapas: 1001, %1</translation>
    </message>
    <message>
        <source>its left and right half share %1 % of the texels: what is painted on one grows on both; a layout of our own parts them</source>
        <translation>sus mitades izquierda y derecha comparten el %1 % de los téxeles: lo que se pinta en una crece en ambas; un despliegue propio las separa</translation>
    </message>
    <message>
        <source>parts of its skin share %1 % of the texels: what is painted on one grows on all; a layout of our own parts them</source>
        <translation>partes de su piel comparten el %1 % de los téxeles: lo que se pinta en una crece en todas; un despliegue propio las separa</translation>
    </message>
    <message>
        <source>several layouts of the head lie in its tile %1, so images by tile would lie over each other; write one image a map</source>
        <translation>varios despliegues de la cabeza están en su mosaico %1, así que las imágenes por mosaico quedarían unas sobre otras; escribe una imagen por mapa</translation>
    </message>
    <message>
        <source>several layouts of the head lie in its tile %1, so images by tile can&apos;t be told apart; paint on one image of all of the map</source>
        <translation>varios despliegues de la cabeza están en su mosaico %1, así que las imágenes por mosaico no se pueden distinguir; pinta en una imagen de todo el mapa</translation>
    </message>
    <message>
        <source>none of its tiles is one of the head&apos;s, as %1 is; number its images by the head&apos;s tiles</source>
        <translation>ninguno de sus mosaicos es de la cabeza, como lo es %1; numere sus imágenes según los mosaicos de la cabeza</translation>
    </message>
    <message>
        <source>tiles that the head has not are left out: %1</source>
        <translation>se dejan fuera los mosaicos que la cabeza no tiene: %1</translation>
    </message>
    <message>
        <source>no file of that name has a tile&apos;s number instead of &lt;UDIM&gt;, as &apos;%1&apos; would; name one image for each tile so</source>
        <translation>ningún archivo de ese nombre tiene el número de un mosaico en lugar de &lt;UDIM&gt;, como lo tendría «%1»; dé un nombre así a la imagen de cada mosaico</translation>
    </message>
    <message>
        <source>its hair is in other files, which are no USD text beside it: %1; export it flattened into one</source>
        <translation>su pelo está en otros archivos, que no son texto USD junto a él: %1; expórtalo aplanado en uno solo</translation>
    </message>
    <message>
        <source>its colours are inks (CMYK), which are read of TIFF and JPEG alone; convert it to RGB, or save it as TIFF, and try again</source>
        <translation>sus colores son tintas (CMYK), que solo se leen de TIFF y JPEG; conviértelo a RGB o guárdalo como TIFF e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>its format, %1, is not read here; save it as PNG or TIFF in the program that made it, and try again</source>
        <translation>su formato, %1, no se lee aquí; guárdalo como PNG o TIFF en el programa que lo creó e inténtalo de nuevo</translation>
    </message>
    <message>
        <source>several of its parts have a layout of their own in uv tile %1, so these lie side by side on the maps; images by tile can&apos;t hold them</source>
        <translation>varias de sus partes tienen un despliegue propio en el mosaico uv %1, así que están uno junto a otro en los mapas; no caben en imágenes por mosaico</translation>
    </message>
    <message>
        <source>not read, so hair that is in there is missing: %1; save it as USD text in the same folder</source>
        <translation>no se leyó, así que falta el pelo que haya ahí: %1; guárdalo como texto USD en la misma carpeta</translation>
    </message>
    <message>
        <source>its mesh has %1 triangles, and what is worn has at most %2; reduce it in a 3D program</source>
        <translation>su malla tiene %1 triángulos, y lo que se lleva tiene %2 como máximo; redúcela en un programa 3D</translation>
    </message>
    <message>
        <source>The mesh &apos;%1&apos; that is worn is lost; put it on anew.</source>
        <translation>La malla «%1» que se lleva se ha perdido; vuelve a ponerla.</translation>
    </message>
</context>
<context>
    <name>GroupSchema</name>
    <message>
        <source>Turns per hair</source>
        <translation>Vueltas por pelo</translation>
    </message>
    <message>
        <source>Turns per length</source>
        <translation>Vueltas por longitud</translation>
    </message>
    <message>
        <source>Greatest length</source>
        <translation>Longitud máxima</translation>
    </message>
    <message>
        <source>Length where the length map is brightest</source>
        <translation>Longitud donde el mapa de longitud es más claro</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>Shortest length</source>
        <translation>Longitud mínima</translation>
    </message>
    <message>
        <source>Length where the length map is 0</source>
        <translation>Longitud donde el mapa de longitud es 0</translation>
    </message>
    <message>
        <source>Greatest density</source>
        <translation>Densidad máxima</translation>
    </message>
    <message>
        <source>Hairs where the density map is brightest</source>
        <translation>Pelos donde el mapa de densidad es más claro</translation>
    </message>
    <message>
        <source>hairs/cm²</source>
        <translation>pelos/cm²</translation>
    </message>
    <message>
        <source>Hair width</source>
        <translation>Grosor del pelo</translation>
    </message>
    <message>
        <source>Diameter of one hair</source>
        <translation>Diámetro de un pelo</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>Curl radius</source>
        <translation>Radio del rizo</translation>
    </message>
    <message>
        <source>Greatest radius of a curl</source>
        <translation>Radio máximo de un rizo</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Nodes per hair</source>
        <translation>Nodos por pelo</translation>
    </message>
    <message>
        <source>More bend more finely and cost more</source>
        <translation>Con más, el pelo se dobla con más detalle y cuesta más</translation>
    </message>
    <message>
        <source>Turns mode</source>
        <translation>Modo de vueltas</translation>
    </message>
    <message>
        <source>What the turns of a curl are counted by</source>
        <translation>Cómo se cuentan las vueltas de un rizo</translation>
    </message>
    <message>
        <source>Turns are for</source>
        <translation>Vueltas en</translation>
    </message>
    <message>
        <source>The length that the turns of a curl are for</source>
        <translation>La longitud a la que se refieren las vueltas de un rizo</translation>
    </message>
    <message>
        <source>Curl levels</source>
        <translation>Niveles de rizo</translation>
    </message>
    <message>
        <source>Whole curl levels only</source>
        <translation>Solo niveles enteros de rizo</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Distance between braids in one painted patch</source>
        <translation>Distancia entre trenzas en una misma zona pintada</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Thickness of a braid; one of few hairs is thinner</source>
        <translation>Grosor de una trenza; la que tiene pocos cabellos es más fina</translation>
    </message>
    <message>
        <source>Knot length</source>
        <translation>Largo del nudo</translation>
    </message>
    <message>
        <source>How long the turns of a braid are; at 100 % its wisps fit each other</source>
        <translation>Qué tan largas son las vueltas de una trenza; con 100 % sus mechones encajan</translation>
    </message>
    <message>
        <source>Tightness</source>
        <translation>Firmeza</translation>
    </message>
    <message>
        <source>How tight braids are laced: loose ones are full, and hairs leave them</source>
        <translation>Qué tan apretadas están las trenzas: las flojas son llenas y sueltan cabellos</translation>
    </message>
    <message>
        <source>How much thinner a braid is at its end</source>
        <translation>Cuánto más fina es una trenza en su punta</translation>
    </message>
    <message>
        <source>Tie</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>How far a braid is drawn together before its loose end</source>
        <translation>Cuánto se ciñe una trenza antes de su punta suelta</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Thickness of the whole coat of hair</source>
        <translation>Espesor de todo el manto de pelo</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
    <message>
        <source>How soon motion dies down</source>
        <translation>Cuán pronto se apaga el movimiento</translation>
    </message>
    <message>
        <source>per s</source>
        <translation>por s</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>100 % is as on earth</source>
        <translation>100 % es como en la Tierra</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Rozamiento</translation>
    </message>
    <message>
        <source>How much hair sticks to the head</source>
        <translation>Cuánto se agarra el pelo a la cabeza</translation>
    </message>
    <message>
        <source>How strongly the wind takes this hair</source>
        <translation>Con qué fuerza el viento mueve este pelo</translation>
    </message>
    <message>
        <source>Shine</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Strength of the highlights</source>
        <translation>Intensidad de los reflejos</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosidad</translation>
    </message>
    <message>
        <source>Width of the highlights</source>
        <translation>Anchura de los reflejos</translation>
    </message>
    <message>
        <source>Opacity at the root</source>
        <translation>Opacidad en la raíz</translation>
    </message>
    <message>
        <source>Less lets the skin show through</source>
        <translation>Con menos se transparenta la piel</translation>
    </message>
    <message>
        <source>Opacity at the tip</source>
        <translation>Opacidad en la punta</translation>
    </message>
    <message>
        <source>Less makes hair thin out</source>
        <translation>Con menos el pelo se afina</translation>
    </message>
    <message>
        <source>Colour variation</source>
        <translation>Variación de color</translation>
    </message>
    <message>
        <source>Difference between neighbouring hairs</source>
        <translation>Diferencia entre pelos vecinos</translation>
    </message>
    <message>
        <source>A hair so long nearly carries itself; shorter hair stands, longer hair hangs</source>
        <translation>Un pelo de esta longitud apenas se sostiene; más corto se mantiene de pie, más largo cuelga</translation>
    </message>
    <message>
        <source>Simulated hairs</source>
        <translation>Pelos simulados</translation>
    </message>
    <message>
        <source>Of the whole scalp; the others follow the nearest of them</source>
        <translation>De todo el cuero cabelludo; los demás siguen a los más cercanos</translation>
    </message>
    <message>
        <source>Stands up to</source>
        <translation>Se sostiene hasta</translation>
    </message>
    <message>
        <source>Moved by wind</source>
        <translation>Lo mueve el viento</translation>
    </message>
    <message>
        <source>Uneven lengths</source>
        <translation>Largos desiguales</translation>
    </message>
    <message>
        <source>How much shorter than the map single hairs are</source>
        <translation>Cuánto más cortos que el mapa son algunos pelos</translation>
    </message>
    <message>
        <source>Crossing hairs</source>
        <translation>Pelos cruzados</translation>
    </message>
    <message>
        <source>How far hairs lie across their neighbours</source>
        <translation>Cuánto se cruzan los pelos con sus vecinos</translation>
    </message>
    <message>
        <source>Flyaways</source>
        <translation>Pelos sueltos</translation>
    </message>
    <message>
        <source>Hairs that keep to no lock and stand off the others</source>
        <translation>Pelos que no siguen ningún mechón y se separan de los demás</translation>
    </message>
    <message>
        <source>Uneven curls</source>
        <translation>Rizos desiguales</translation>
    </message>
    <message>
        <source>How much turns and radius of curls differ</source>
        <translation>Cuánto varían las vueltas y el radio de los rizos</translation>
    </message>
    <message>
        <source>Uneven widths</source>
        <translation>Grosores desiguales</translation>
    </message>
    <message>
        <source>How much the diameters of hairs differ</source>
        <translation>Cuánto varían los diámetros de los pelos</translation>
    </message>
    <message>
        <source>Grey hairs</source>
        <translation>Canas</translation>
    </message>
    <message>
        <source>How many of the hairs are grey</source>
        <translation>Cuántos de los pelos son canas</translation>
    </message>
    <message>
        <source>Uneven by at most</source>
        <translation>Desigual como máximo</translation>
    </message>
    <message>
        <source>How much shorter single hairs are at most; at 0 there is no limit</source>
        <translation>Cuánto más cortos son como máximo los cabellos sueltos; con 0 no hay límite</translation>
    </message>
    <message>
        <source>Bare parting</source>
        <translation>Raya despejada</translation>
    </message>
    <message>
        <source>Width of the line of skin that a parting bares</source>
        <translation>Ancho de la línea de piel que deja ver una raya</translation>
    </message>
    <message>
        <source>Uneven patches</source>
        <translation>Zonas desiguales</translation>
    </message>
    <message>
        <source>How far density and length differ in soft patches</source>
        <translation>Cuánto varían densidad y longitud en zonas suaves</translation>
    </message>
    <message>
        <source>Uneven hairline</source>
        <translation>Nacimiento irregular</translation>
    </message>
    <message>
        <source>How far a soft hairline wavers</source>
        <translation>Cuánto ondula un nacimiento suave</translation>
    </message>
    <message>
        <source>Straight at the root</source>
        <translation>Liso en la raíz</translation>
    </message>
    <message>
        <source>How far from the scalp hair begins to curl</source>
        <translation>A qué distancia del cuero cabelludo empieza a rizarse el pelo</translation>
    </message>
    <message>
        <source>Loft</source>
        <translation>Realce</translation>
    </message>
    <message>
        <source>How well the coat keeps its height under its weight</source>
        <translation>Cuánto conserva el pelo su altura bajo su peso</translation>
    </message>
    <message>
        <source>Loose parting</source>
        <translation>Raya suelta</translation>
    </message>
    <message>
        <source>How far from a parting hairs still cross it</source>
        <translation>Hasta qué distancia de una raya la cruzan cabellos</translation>
    </message>
    <message>
        <source>Volume rises over</source>
        <translation>El volumen crece en</translation>
    </message>
    <message>
        <source>How far from its roots hair reaches its height in the coat</source>
        <translation>A qué distancia de la raíz alcanza el pelo su altura en la masa</translation>
    </message>
    <message>
        <source>Scalp tint</source>
        <translation>Tono del cuero cabelludo</translation>
    </message>
    <message>
        <source>How much the roots darken the skin where they are dense</source>
        <translation>Cuánto oscurecen la piel las raíces donde son densas</translation>
    </message>
    <message>
        <source>Coils measured in mm</source>
        <translation>Rizos medidos en mm</translation>
    </message>
    <message>
        <source>Coil diameter</source>
        <translation>Diámetro del rizo</translation>
    </message>
    <message>
        <source>Of a coil where no curl size is painted; an S is as wide</source>
        <translation>De un rizo donde no hay tamaño pintado; una S es igual de ancha</translation>
    </message>
    <message>
        <source>Coil pitch</source>
        <translation>Paso del rizo</translation>
    </message>
    <message>
        <source>From turn to turn along the hair where the curl map is brightest</source>
        <translation>De vuelta a vuelta a lo largo del cabello donde el mapa de rizo es más claro</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>0 is a coil, 100 % a wave in the shape of an S</source>
        <translation>0 es un rizo, 100 % una onda en forma de S</translation>
    </message>
    <message>
        <source>In step from</source>
        <translation>Al compás desde</translation>
    </message>
    <message>
        <source>How far from the scalp the hairs of a lock curl together; before it each alone</source>
        <translation>A qué distancia del cuero cabelludo los pelos de un mechón se rizan juntos; antes, cada uno por su cuenta</translation>
    </message>
    <message>
        <source>Switchbacks</source>
        <translation>Cambios de sentido</translation>
    </message>
    <message>
        <source>How often a coil turns the other way and leaves a kink</source>
        <translation>Con qué frecuencia un rizo gira al revés y deja un quiebro</translation>
    </message>
    <message>
        <source>per 10 cm</source>
        <translation>por 10 cm</translation>
    </message>
    <message>
        <source>Skipped turns</source>
        <translation>Vueltas saltadas</translation>
    </message>
    <message>
        <source>How many turns single hairs leap over</source>
        <translation>Cuántas vueltas se saltan los pelos sueltos</translation>
    </message>
    <message>
        <source>Drawn by weight</source>
        <translation>Estirado por el peso</translation>
    </message>
    <message>
        <source>How much looser long curls are at the root than on the whole</source>
        <translation>Cuánto más flojos son los rizos largos en la raíz que en conjunto</translation>
    </message>
    <message>
        <source>Curls shorten</source>
        <translation>Los rizos acortan</translation>
    </message>
    <message>
        <source>Curls shorten hair: lengths are as cut</source>
        <translation>Los rizos acortan el cabello: los largos son los del corte</translation>
    </message>
    <message>
        <source>Curls gather</source>
        <translation>Los rizos se juntan</translation>
    </message>
    <message>
        <source>How closely curled hair gathers in locks where no clump is painted</source>
        <translation>Cuánto se junta en mechones el cabello rizado donde no hay agrupación pintada</translation>
    </message>
    <message>
        <source>Lock size</source>
        <translation>Tamaño del mechón</translation>
    </message>
    <message>
        <source>Distance of locks; at 0 each simulated hair has its own</source>
        <translation>Distancia entre mechones; con 0 cada pelo simulado tiene el suyo</translation>
    </message>
    <message>
        <source>Small locks</source>
        <translation>Mechones pequeños</translation>
    </message>
    <message>
        <source>How far each lock is made of small ones, a simulated hair each</source>
        <translation>Hasta qué punto cada mechón se compone de otros pequeños, uno por pelo simulado</translation>
    </message>
    <message>
        <source>Flat locks</source>
        <translation>Mechones planos</translation>
    </message>
    <message>
        <source>0 is round, 100 % a ribbon along the skin</source>
        <translation>0 es redondo, 100 % una cinta sobre la piel</translation>
    </message>
    <message>
        <source>Twisted locks</source>
        <translation>Mechones torcidos</translation>
    </message>
    <message>
        <source>How often a lock turns about itself</source>
        <translation>Cuántas vueltas da un mechón sobre sí mismo</translation>
    </message>
    <message>
        <source>Ragged edges</source>
        <translation>Bordes irregulares</translation>
    </message>
    <message>
        <source>How many hairs at the edge of a lock belong to the next</source>
        <translation>Cuántos pelos del borde de un mechón pertenecen al siguiente</translation>
    </message>
    <message>
        <source>Open tips</source>
        <translation>Puntas abiertas</translation>
    </message>
    <message>
        <source>How far hairs leave their lock near the tip</source>
        <translation>Cuánto se separan los pelos de su mechón cerca de la punta</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>How strongly hair keeps out of hair and moves along with it</source>
        <translation>Con qué fuerza el pelo se aparta del pelo y se mueve con él</translation>
    </message>
    <message>
        <source>Greatest frizz</source>
        <translation>Encrespado máximo</translation>
    </message>
    <message>
        <source>How far hair strays from its course where the frizz map is brightest</source>
        <translation>Cuánto se aparta el pelo de su curso donde el mapa de encrespado es más claro</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Afinado</translation>
    </message>
    <message>
        <source>Length over which a hair thins out to its tip; at 0 it does over all of it</source>
        <translation>Largo en el que un pelo se afina hasta la punta; con 0 lo hace en todo su largo</translation>
    </message>
    <message>
        <source>Tip colour from</source>
        <translation>Color de puntas desde</translation>
    </message>
    <message>
        <source>How far from the root the tip colour begins, of the length</source>
        <translation>A qué distancia de la raíz empieza el color de puntas, en parte del largo</translation>
    </message>
    <message>
        <source>Tip colour over</source>
        <translation>Color de puntas a lo largo de</translation>
    </message>
    <message>
        <source>How softly it begins: at 0 % in a line, at 100 % all the way to the tip</source>
        <translation>Con qué suavidad empieza: con 0 % en una línea, con 100 % hasta la punta</translation>
    </message>
    <message>
        <source>Soft hairline</source>
        <translation>Nacimiento suave</translation>
    </message>
    <message>
        <source>Width over which hair grows thinner, shorter and finer towards bare skin</source>
        <translation>Anchura en la que el pelo se hace más ralo, más corto y más fino hacia la piel desnuda</translation>
    </message>
    <message>
        <source>Baby hairs</source>
        <translation>Pelusa</translation>
    </message>
    <message>
        <source>How many hairs of a soft hairline are short, fine and curl a little</source>
        <translation>Cuántos pelos de un nacimiento suave son cortos, finos y algo rizados</translation>
    </message>
    <message>
        <source>Flat fibres</source>
        <translation>Fibras planas</translation>
    </message>
    <message>
        <source>Longest over shortest diameter of a hair: round is 1, coily hair nearly 2</source>
        <translation>Diámetro mayor de un pelo entre el menor: redondo es 1; el pelo muy rizado, casi 2</translation>
    </message>
</context>
<context>
    <name>Guarded</name>
    <message>
        <source>%1: there is not enough memory for it; close other programs, or take something smaller.</source>
        <translation>%1: no hay memoria suficiente; cierra otros programas o elige algo más pequeño.</translation>
    </message>
    <message>
        <source>%1 failed: %2; try again, and report it where it fails again.</source>
        <translation>%1: falló (%2); inténtalo de nuevo e informa de ello si vuelve a fallar.</translation>
    </message>
</context>
<context>
    <name>HairColours</name>
    <message>
        <source>1 Black</source>
        <translation>1 Negro</translation>
    </message>
    <message>
        <source>2 Darkest brown</source>
        <translation>2 Castaño muy oscuro</translation>
    </message>
    <message>
        <source>3 Dark brown</source>
        <translation>3 Castaño oscuro</translation>
    </message>
    <message>
        <source>4 Medium brown</source>
        <translation>4 Castaño medio</translation>
    </message>
    <message>
        <source>5 Light brown</source>
        <translation>5 Castaño claro</translation>
    </message>
    <message>
        <source>6 Dark blonde</source>
        <translation>6 Rubio oscuro</translation>
    </message>
    <message>
        <source>7 Medium blonde</source>
        <translation>7 Rubio medio</translation>
    </message>
    <message>
        <source>8 Light blonde</source>
        <translation>8 Rubio claro</translation>
    </message>
    <message>
        <source>9 Very light blonde</source>
        <translation>9 Rubio muy claro</translation>
    </message>
    <message>
        <source>10 Lightest blonde</source>
        <translation>10 Rubio clarísimo</translation>
    </message>
    <message>
        <source>Mahogany</source>
        <translation>Caoba</translation>
    </message>
    <message>
        <source>Auburn</source>
        <translation>Cobrizo oscuro</translation>
    </message>
    <message>
        <source>Chestnut</source>
        <translation>Castaño rojizo</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Cobre</translation>
    </message>
    <message>
        <source>Ginger</source>
        <translation>Pelirrojo</translation>
    </message>
    <message>
        <source>Strawberry blonde</source>
        <translation>Rubio fresa</translation>
    </message>
    <message>
        <source>Steel grey</source>
        <translation>Gris acero</translation>
    </message>
    <message>
        <source>Salt and pepper</source>
        <translation>Entrecano</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>Plata</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>Burgundy</source>
        <translation>Burdeos</translation>
    </message>
    <message>
        <source>Cherry red</source>
        <translation>Rojo cereza</translation>
    </message>
    <message>
        <source>Coral</source>
        <translation>Coral</translation>
    </message>
    <message>
        <source>Rose</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Lilac</source>
        <translation>Lila</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violeta</translation>
    </message>
    <message>
        <source>Midnight blue</source>
        <translation>Azul medianoche</translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation>Turquesa</translation>
    </message>
    <message>
        <source>Mint</source>
        <translation>Menta</translation>
    </message>
</context>
<context>
    <name>HairHandles</name>
    <message>
        <source>Length all over</source>
        <translation>Largo general</translation>
    </message>
    <message>
        <source>All of this hair longer or shorter; 100% is as it was</source>
        <translation>Todo este pelo más largo o más corto; 100 % es como estaba</translation>
    </message>
    <message>
        <source>Length of &quot;%1&quot;</source>
        <translation>Largo de «%1»</translation>
    </message>
    <message>
        <source>Fringe length</source>
        <translation>Largo del flequillo</translation>
    </message>
    <message>
        <source>Hair over the forehead longer or shorter</source>
        <translation>El pelo sobre la frente, más largo o más corto</translation>
    </message>
    <message>
        <source>Fringe of &quot;%1&quot;</source>
        <translation>Flequillo de «%1»</translation>
    </message>
    <message>
        <source>Fade height</source>
        <translation>Altura del degradado</translation>
    </message>
    <message>
        <source>How much higher clipped hair ends at the sides and the back</source>
        <translation>Cuánto más arriba termina el pelo rapado en los lados y la nuca</translation>
    </message>
    <message>
        <source>Fade of &quot;%1&quot;</source>
        <translation>Degradado de «%1»</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Raya</translation>
    </message>
    <message>
        <source>Where hair falls to both sides; left is the head&apos;s own left</source>
        <translation>Dónde cae el pelo a ambos lados; la izquierda es la de la propia cabeza</translation>
    </message>
    <message>
        <source>Part of &quot;%1&quot;</source>
        <translation>Raya de «%1»</translation>
    </message>
</context>
<context>
    <name>HairKinds</name>
    <message>
        <source>Hair of the head</source>
        <translation>Pelo de la cabeza</translation>
    </message>
    <message>
        <source>Brows</source>
        <translation>Cejas</translation>
    </message>
    <message>
        <source>Lashes</source>
        <translation>Pestañas</translation>
    </message>
    <message>
        <source>Beard</source>
        <translation>Barba</translation>
    </message>
    <message>
        <source>Something else</source>
        <translation>Otra cosa</translation>
    </message>
</context>
<context>
    <name>HairScale</name>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>Curl size</source>
        <translation>Radio del rizo</translation>
    </message>
</context>
<context>
    <name>HeadView</name>
    <message>
        <source>The window has no OpenGL context.</source>
        <translation>La ventana no tiene contexto OpenGL.</translation>
    </message>
    <message>
        <source>The graphics driver was reset. Until the next start the hair is drawn without it.</source>
        <translation>El controlador gráfico se reinició. Hasta el próximo inicio, el pelo se dibuja sin él.</translation>
    </message>
</context>
<context>
    <name>Heads</name>
    <message>
        <source>Mannequin of version 0.1</source>
        <translation>Maniquí de la versión 0.1</translation>
    </message>
    <message>
        <source>Display bust</source>
        <translation>Busto de exposición</translation>
    </message>
</context>
<context>
    <name>HoldHair</name>
    <message>
        <source>Holding the hair</source>
        <translation>Fijando el pelo</translation>
    </message>
    <message>
        <source>Nothing to hold: this hair hangs by its weight, or its gel holds it already.</source>
        <translation>No hay nada que fijar: este pelo cuelga por su peso o su gel ya lo fija.</translation>
    </message>
    <message>
        <source>There is no hair to hold in this group.</source>
        <translation>No hay pelo que fijar en este grupo.</translation>
    </message>
    <message>
        <source>The hair is not held: cancelled</source>
        <translation>El pelo no se fijó: cancelado</translation>
    </message>
</context>
<context>
    <name>Journal</name>
    <message>
        <source>its folder can&apos;t be written to; check that you may write there</source>
        <translation>no se puede escribir en su carpeta; comprueba que puedes escribir ahí</translation>
    </message>
</context>
<context>
    <name>Landmarks</name>
    <message>
        <source>crown</source>
        <translation>coronilla</translation>
    </message>
    <message>
        <source>hairline</source>
        <translation>nacimiento del pelo</translation>
    </message>
    <message>
        <source>nape</source>
        <translation>nuca</translation>
    </message>
    <message>
        <source>nose</source>
        <translation>nariz</translation>
    </message>
    <message>
        <source>chin</source>
        <translation>barbilla</translation>
    </message>
    <message>
        <source>L</source>
        <translation>I</translation>
    </message>
    <message>
        <source>R</source>
        <translation>D</translation>
    </message>
    <message>
        <source>left ear</source>
        <translation>oreja izquierda</translation>
    </message>
    <message>
        <source>right ear</source>
        <translation>oreja derecha</translation>
    </message>
</context>
<context>
    <name>LandmarksDialog</name>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <extracomment>What your language calls itself, with a capital letter: it stands so in the Preferences.</extracomment>
        <translation>Español</translation>
    </message>
</context>
<context>
    <name>LengthUnits</name>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>Decimetres</source>
        <translation>Decímetros</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Y (glTF, Maya)</source>
        <translation>Y (glTF, Maya)</translation>
    </message>
    <message>
        <source>Z (Blender, 3ds Max)</source>
        <translation>Z (Blender, 3ds Max)</translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>There is no style named &apos;%1&apos;; &apos;hairpaint presets&apos; lists those there are.</source>
        <translation>No hay ningún peinado llamado «%1»; «hairpaint presets» muestra los que hay.</translation>
    </message>
    <message>
        <source>The style is now &apos;%1&apos;, but its old file &apos;%2&apos; could not be removed; delete it by hand.</source>
        <translation>El estilo se llama ahora &apos;%1&apos;, pero no se pudo quitar su archivo anterior &apos;%2&apos;; bórralo a mano.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; could not be made; check that you may write there.</source>
        <translation>No se pudo crear la carpeta «%1»; comprueba que puedes escribir ahí.</translation>
    </message>
</context>
<context>
    <name>Light</name>
    <message>
        <source>Studio</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Daylight</source>
        <translation>Luz de día</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Atardecer</translation>
    </message>
    <message>
        <source>Club</source>
        <translation>Discoteca</translation>
    </message>
    <message>
        <source>Backlit</source>
        <translation>Contraluz</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Marschner</source>
        <translation>Marschner</translation>
    </message>
    <message>
        <source>Kajiya-Kay</source>
        <translation>Kajiya-Kay</translation>
    </message>
    <message>
        <source>Illuminated lines</source>
        <translation>Líneas iluminadas</translation>
    </message>
</context>
<context>
    <name>MapLetter</name>
    <message>
        <source>P</source>
        <translation>N</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>C</source>
        <translation>R</translation>
    </message>
    <message>
        <source>B</source>
        <translation>T</translation>
    </message>
    <message>
        <source>H</source>
        <translation>C</translation>
    </message>
    <message>
        <source>U</source>
        <translation>M</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>S</source>
        <translation>A</translation>
    </message>
    <message>
        <source>T</source>
        <translation>P</translation>
    </message>
    <message>
        <source>R</source>
        <translation>O</translation>
    </message>
    <message>
        <source>F</source>
        <translation>E</translation>
    </message>
    <message>
        <source>W</source>
        <translation>S</translation>
    </message>
    <message>
        <source>O</source>
        <translation>U</translation>
    </message>
    <message>
        <source>A</source>
        <translation>I</translation>
    </message>
</context>
<context>
    <name>MapScale</name>
    <message>
        <source>hairs/cm²</source>
        <translation>pelos/cm²</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>vueltas</translation>
    </message>
    <message>
        <source>turns per %1 cm</source>
        <translation>vueltas cada %1 cm</translation>
    </message>
</context>
<context>
    <name>MapSpec</name>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Plait</source>
        <translation>Trenza</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torcido</translation>
    </message>
    <message>
        <source>Loc</source>
        <translation>Rasta</translation>
    </message>
    <message>
        <source>Plait of four</source>
        <translation>Trenza de cuatro</translation>
    </message>
    <message>
        <source>Plait of five</source>
        <translation>Trenza de cinco</translation>
    </message>
    <message>
        <source>Fishtail</source>
        <translation>Espiga</translation>
    </message>
    <message>
        <source>Cornrow</source>
        <translation>Trenza pegada</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Curl</source>
        <translation>Rizo</translation>
    </message>
    <message>
        <source>Braid</source>
        <translation>Trenzado</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Clump</source>
        <translation>Mechón</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>Gel</translation>
    </message>
    <message>
        <source>Curl size</source>
        <translation>Radio del rizo</translation>
    </message>
    <message>
        <source>Tip colour</source>
        <translation>Color de puntas</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Frizz</source>
        <translation>Encrespado</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Lustre</translation>
    </message>
    <message>
        <source>Tip start</source>
        <translation>Inicio de puntas</translation>
    </message>
    <message>
        <source>Ponytail</source>
        <translation>Coleta</translation>
    </message>
    <message>
        <source>Bun</source>
        <translation>Moño</translation>
    </message>
    <message>
        <source>Headband</source>
        <translation>Diadema</translation>
    </message>
    <message>
        <source>Ribbon bow</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>Hairpin</source>
        <translation>Horquilla</translation>
    </message>
    <message>
        <source>Bead</source>
        <translation>Cuenta</translation>
    </message>
    <message>
        <source>Accessories</source>
        <translation>Accesorios</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Scalp</source>
        <translation>Cuero cabelludo</translation>
    </message>
    <message>
        <source>Long straight</source>
        <translation>Larga y lisa</translation>
    </message>
    <message>
        <source>Bob</source>
        <translation>Media melena</translation>
    </message>
    <message>
        <source>Ringlets</source>
        <translation>Tirabuzones</translation>
    </message>
    <message>
        <source>Round afro</source>
        <translation>Afro redondo</translation>
    </message>
    <message>
        <source>Two plaits</source>
        <translation>Dos trenzas</translation>
    </message>
    <message>
        <source>Gelled mohawk</source>
        <translation>Cresta con gel</translation>
    </message>
    <message>
        <source>Split dye</source>
        <translation>A dos colores</translation>
    </message>
    <message>
        <source>Buzz cut</source>
        <translation>Rapado</translation>
    </message>
    <message>
        <source>short</source>
        <translation>corto</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>medio</translation>
    </message>
    <message>
        <source>long</source>
        <translation>largo</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>liso</translation>
    </message>
    <message>
        <source>wavy</source>
        <translation>ondulado</translation>
    </message>
    <message>
        <source>curly</source>
        <translation>rizado</translation>
    </message>
    <message>
        <source>coily</source>
        <translation>afro</translation>
    </message>
    <message>
        <source>braided</source>
        <translation>trenzado</translation>
    </message>
    <message>
        <source>gelled</source>
        <translation>con gel</translation>
    </message>
    <message>
        <source>coloured</source>
        <translation>teñido</translation>
    </message>
    <message>
        <source>built-in</source>
        <translation>incluido</translation>
    </message>
    <message>
        <source>own</source>
        <translation>propio</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupo %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Capa %1</translation>
    </message>
    <message>
        <source>Brows</source>
        <translation>Cejas</translation>
    </message>
    <message>
        <source>Lashes</source>
        <translation>Pestañas</translation>
    </message>
    <message>
        <source>Beard</source>
        <translation>Barba</translation>
    </message>
    <message>
        <source>Bald</source>
        <translation>Sin pelo</translation>
    </message>
    <message>
        <source>Slicked undercut</source>
        <translation>Undercut engominado</translation>
    </message>
    <message>
        <source>Quiff</source>
        <translation>Tupé</translation>
    </message>
    <message>
        <source>Side part</source>
        <translation>Raya al lado</translation>
    </message>
    <message>
        <source>French crop</source>
        <translation>Corte francés</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>High ponytail</source>
        <translation>Coleta alta</translation>
    </message>
    <message>
        <source>Low bun</source>
        <translation>Moño bajo</translation>
    </message>
    <message>
        <source>Half-up with bow</source>
        <translation>Semirrecogido con lazo</translation>
    </message>
    <message>
        <source>Twin tails</source>
        <translation>Dos coletas</translation>
    </message>
    <message>
        <source>Top knot with undercut</source>
        <translation>Moño alto con rapado</translation>
    </message>
    <message>
        <source>Crown braid</source>
        <translation>Trenza de corona</translation>
    </message>
    <message>
        <source>Fishtail plait</source>
        <translation>Trenza de espiga</translation>
    </message>
    <message>
        <source>Box braids</source>
        <translation>Trenzas africanas</translation>
    </message>
    <message>
        <source>Cornrows</source>
        <translation>Trenzas pegadas</translation>
    </message>
    <message>
        <source>Locs</source>
        <translation>Rastas</translation>
    </message>
    <message>
        <source>Pixie</source>
        <translation>Corte pixie</translation>
    </message>
    <message>
        <source>Curtain layers</source>
        <translation>Capas con flequillo cortina</translation>
    </message>
    <message>
        <source>Jaw bob with fringe</source>
        <translation>Bob a la mandíbula con flequillo</translation>
    </message>
    <message>
        <source>Beach waves balayage</source>
        <translation>Ondas de playa balayage</translation>
    </message>
    <message>
        <source>Wolf cut</source>
        <translation>Corte wolf</translation>
    </message>
    <message>
        <source>Shag</source>
        <translation>Corte shag</translation>
    </message>
    <message>
        <source>Curly bob</source>
        <translation>Bob rizado</translation>
    </message>
    <message>
        <source>Curly top with fade</source>
        <translation>Rizos con degradado</translation>
    </message>
    <message>
        <source>High-top fade</source>
        <translation>Copete alto con degradado</translation>
    </message>
    <message>
        <source>Liberty spikes</source>
        <translation>Púas punk</translation>
    </message>
    <message>
        <source>Fade with line-up</source>
        <translation>Degradado perfilado</translation>
    </message>
    <message>
        <source>Stubble</source>
        <translation>Barba de tres días</translation>
    </message>
    <message>
        <source>Goatee</source>
        <translation>Perilla</translation>
    </message>
    <message>
        <source>Full beard</source>
        <translation>Barba completa</translation>
    </message>
    <message>
        <source>Low ponytail</source>
        <translation>Coleta baja</translation>
    </message>
    <message>
        <source>Hime cut</source>
        <translation>Corte hime</translation>
    </message>
    <message>
        <source>Headband with long hair</source>
        <translation>Diadema con pelo largo</translation>
    </message>
    <message>
        <source>Bantu knots</source>
        <translation>Nudos bantú</translation>
    </message>
    <message>
        <source>Twist-out</source>
        <translation>Twist-out</translation>
    </message>
    <message>
        <source>360 waves</source>
        <translation>Ondas 360</translation>
    </message>
    <message>
        <source>Full brows</source>
        <translation>Cejas pobladas</translation>
    </message>
    <message>
        <source>tied</source>
        <translation>recogido</translation>
    </message>
    <message>
        <source>beard</source>
        <translation>barba</translation>
    </message>
    <message>
        <source>face</source>
        <translation>rostro</translation>
    </message>
</context>
<context>
    <name>NumberText</name>
    <message>
        <source>There is no number.</source>
        <translation>No hay ningún número.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>Nada se puede dividir entre 0.</translation>
    </message>
    <message>
        <source>“%1” means nothing here; type the number alone.</source>
        <translation>«%1» no significa nada aquí; escribe solo el número.</translation>
    </message>
    <message>
        <source>“%1” is no unit for this; use %2.</source>
        <translation>«%1» no es una unidad válida aquí; usa %2.</translation>
    </message>
    <message>
        <source>mm|millimetre|millimetres|millimeter|millimeters</source>
        <translation>mm|milímetro|milímetros</translation>
    </message>
    <message>
        <source>cm|centimetre|centimetres|centimeter|centimeters</source>
        <translation>cm|centímetro|centímetros</translation>
    </message>
    <message>
        <source>m|metre|metres|meter|meters</source>
        <translation>m|metro|metros</translation>
    </message>
    <message>
        <source>in|inch|inches|&quot;|&apos;&apos;</source>
        <translation>pulg|pulgada|pulgadas</translation>
    </message>
    <message>
        <source>ft|foot|feet|&apos;</source>
        <translation>pie|pies</translation>
    </message>
    <message>
        <source>°|deg|degree|degrees</source>
        <translation>°|grado|grados</translation>
    </message>
    <message>
        <source>rad|radian|radians</source>
        <translation>rad|radián|radianes</translation>
    </message>
    <message>
        <source>hairs/cm²|/cm²</source>
        <translation>pelos/cm²</translation>
    </message>
    <message>
        <source>hairs/mm²|/mm²</source>
        <translation>pelos/mm²</translation>
    </message>
    <message>
        <source>hairs/in²|/in²</source>
        <translation>pelos/in²|pelos/pulg²</translation>
    </message>
    <message>
        <source>“%1” is not a number; type one such as 12 or 0.5.</source>
        <translation>“%1” no es un número; escribe uno como 12 o 0,5.</translation>
    </message>
    <message>
        <source>“%1” is too large a number; type a smaller one.</source>
        <translation>“%1” es un número demasiado grande; escribe uno menor.</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>Drawing the picture was cancelled.</source>
        <translation>Se canceló el dibujo de la imagen.</translation>
    </message>
    <message>
        <source>pictures in linear light have at most %1 million pixels; choose a smaller size, or PNG</source>
        <translation>las imágenes en luz lineal tienen como mucho %1 millones de píxeles; elige un tamaño menor, o PNG</translation>
    </message>
    <message>
        <source>there is no picture of that size; choose another</source>
        <translation>no hay ninguna imagen de ese tamaño; elige otro</translation>
    </message>
</context>
<context>
    <name>ProjectQuestions</name>
    <message>
        <source>Open project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>¿Guardar los cambios?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changes that are not saved.</source>
        <translation>«%1» tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation>Hair Paint</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is open in another window. What is saved in one of them would replace what was saved in the other.</source>
        <translation>«%1» está abierto en otra ventana. Lo que se guarde en una de ellas reemplazaría lo guardado en la otra.</translation>
    </message>
    <message>
        <source>&amp;Open anyway</source>
        <translation>&amp;Abrir de todos modos</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was changed by another program since it was opened or saved here. Replacing it would lose those changes.</source>
        <translation>Otro programa cambió «%1» desde que se abrió o guardó aquí. Reemplazarlo haría perder esos cambios.</translation>
    </message>
    <message>
        <source>&amp;Save under another name...</source>
        <translation>&amp;Guardar con otro nombre...</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>&amp;Open what can be read</source>
        <translation>&amp;Abrir lo que se pueda leer</translation>
    </message>
    <message>
        <source>What is left of it can be opened as a new project; the file stays as it is.</source>
        <translation>Lo que queda de él se puede abrir como un proyecto nuevo; el archivo queda como está.</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Buscando trabajo sin guardar</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Dibujando la imagen</translation>
    </message>
    <message>
        <source>Unsaved work was not looked for: cancelled; the next start looks again</source>
        <translation>No se buscó trabajo sin guardar: cancelado; el próximo inicio vuelve a buscarlo</translation>
    </message>
</context>
<context>
    <name>Rendering</name>
    <message>
        <source>EGL is not installed.</source>
        <translation>EGL no está instalado.</translation>
    </message>
    <message>
        <source>EGL offers no OpenGL 4.3 context without a display.</source>
        <translation>EGL no ofrece ningún contexto OpenGL 4.3 sin pantalla.</translation>
    </message>
    <message>
        <source>The OpenGL driver refuses to draw.</source>
        <translation>El controlador OpenGL se niega a dibujar.</translation>
    </message>
    <message>
        <source>Windows offers no OpenGL 4.3 context.</source>
        <translation>Windows no ofrece ningún contexto OpenGL 4.3.</translation>
    </message>
    <message>
        <source>OpenGL 4.3 is needed; this driver has %1.</source>
        <translation>Hace falta OpenGL 4.3; este controlador tiene %1.</translation>
    </message>
</context>
<context>
    <name>RevealedText</name>
    <message>
        <source>reveals the layers below</source>
        <translation>deja ver las capas de abajo</translation>
    </message>
    <message>
        <source>reveals %1, the default</source>
        <translation>deja ver %1, lo predeterminado</translation>
    </message>
    <message>
        <source>reveals the map %1</source>
        <translation>deja ver el mapa %1</translation>
    </message>
    <message>
        <source>reveals how hair naturally lies</source>
        <translation>descubre cómo cae el pelo de forma natural</translation>
    </message>
</context>
<context>
    <name>RowRepeat</name>
    <message>
        <source>The braid map of this group has no layer to paint on.</source>
        <translation>El mapa de trenzas de este grupo no tiene capa en la que pintar.</translation>
    </message>
    <message>
        <source>Fewer than two cornrows reach into the selection: select two.</source>
        <translation>Menos de dos trenzas pegadas llegan a la selección: selecciona dos.</translation>
    </message>
    <message>
        <source>There are fewer than two cornrows: paint two strips of Cornrow on the braid map first.</source>
        <translation>Hay menos de dos trenzas pegadas: pinta antes dos franjas de trenza pegada en el mapa de trenzas.</translation>
    </message>
    <message>
        <source>More than two cornrows reach into the selection: select two of them.</source>
        <translation>Más de dos trenzas pegadas llegan a la selección: selecciona dos de ellas.</translation>
    </message>
    <message>
        <source>Which two of the cornrows? Select an area that two reach into.</source>
        <translation>¿Qué dos trenzas pegadas? Selecciona una zona a la que lleguen dos.</translation>
    </message>
</context>
<context>
    <name>SaveDialog</name>
    <message>
        <source>There is a file &apos;%1&apos; already. Replace it?</source>
        <translation>Ya hay un archivo «%1». ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Looking for the folder</source>
        <translation>Buscando la carpeta</translation>
    </message>
    <message>
        <source>The folder used last was not looked for: cancelled</source>
        <translation>No se buscó la última carpeta usada: cancelado</translation>
    </message>
</context>
<context>
    <name>SkinTone</name>
    <message>
        <source>Neutral clay</source>
        <translation>Arcilla neutra</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>Porcelana</translation>
    </message>
    <message>
        <source>Fair</source>
        <translation>Clara</translation>
    </message>
    <message>
        <source>Beige</source>
        <translation>Beis</translation>
    </message>
    <message>
        <source>Olive</source>
        <translation>Oliva</translation>
    </message>
    <message>
        <source>Brown</source>
        <translation>Morena</translation>
    </message>
    <message>
        <source>Deep</source>
        <translation>Oscura</translation>
    </message>
    <message>
        <source>The head&apos;s own picture</source>
        <translation>La imagen propia de la cabeza</translation>
    </message>
</context>
<context>
    <name>StyleFolders</name>
    <message>
        <source>All</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoritos</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Short</source>
        <translation>Cortos</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medios</translation>
    </message>
    <message>
        <source>Long</source>
        <translation>Largos</translation>
    </message>
    <message>
        <source>Curly and coily</source>
        <translation>Rizados y afro</translation>
    </message>
    <message>
        <source>Tied</source>
        <translation>Recogidos</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Rostro</translation>
    </message>
    <message>
        <source>Mine</source>
        <translation>Míos</translation>
    </message>
</context>
<context>
    <name>StyleOrders</name>
    <message>
        <source>Rename style…</source>
        <translation>Cambiar el nombre…</translation>
    </message>
    <message>
        <source>Tags…</source>
        <translation>Etiquetas…</translation>
    </message>
    <message>
        <source>Replace with the hair on the head</source>
        <translation>Sustituir por el pelo de la cabeza</translation>
    </message>
    <message>
        <source>New picture from this view</source>
        <translation>Nueva imagen desde esta vista</translation>
    </message>
    <message>
        <source>Export style…</source>
        <translation>Exportar peinado…</translation>
    </message>
    <message>
        <source>Delete style</source>
        <translation>Eliminar peinado</translation>
    </message>
    <message>
        <source>About this style…</source>
        <translation>Acerca de este peinado…</translation>
    </message>
</context>
<context>
    <name>StyleParts</name>
    <message>
        <source>All of it</source>
        <translation>Todo el peinado</translation>
    </message>
    <message>
        <source>Apply style &quot;%1&quot;</source>
        <translation>Aplicar peinado «%1»</translation>
    </message>
    <message>
        <source>Only its colour</source>
        <translation>Solo el color</translation>
    </message>
    <message>
        <source>Style &quot;%1&quot; (colour only)</source>
        <translation>Peinado «%1» (solo el color)</translation>
    </message>
    <message>
        <source>Only its cut</source>
        <translation>Solo el corte</translation>
    </message>
    <message>
        <source>Style &quot;%1&quot; (cut only)</source>
        <translation>Peinado «%1» (solo el corte)</translation>
    </message>
    <message>
        <source>Only its curl</source>
        <translation>Solo el rizo</translation>
    </message>
    <message>
        <source>Style &quot;%1&quot; (curl only)</source>
        <translation>Peinado «%1» (solo el rizo)</translation>
    </message>
    <message>
        <source>Only its ties</source>
        <translation>Solo los recogidos</translation>
    </message>
    <message>
        <source>Style &quot;%1&quot; (ties only)</source>
        <translation>Peinado «%1» (solo los recogidos)</translation>
    </message>
    <message>
        <source>%1, %2%</source>
        <translation>%1, %2 %</translation>
    </message>
</context>
<context>
    <name>StyleStrip</name>
    <message>
        <source>Show all styles</source>
        <translation>Mostrar todos los peinados</translation>
    </message>
    <message>
        <source>No style is found for &apos;%1&apos;</source>
        <translation>No se encuentra ningún peinado para «%1»</translation>
    </message>
    <message>
        <source>No style in &apos;%1&apos; is found for &apos;%2&apos;</source>
        <translation>En «%1» no se encuentra ningún peinado para «%2»</translation>
    </message>
    <message>
        <source>Search in all folders</source>
        <translation>Buscar en todas las carpetas</translation>
    </message>
    <message>
        <source>The star in a picture&apos;s corner brings a style here.</source>
        <translation>La estrella en la esquina de una imagen trae aquí un peinado.</translation>
    </message>
    <message>
        <source>Styles that you put on come here.</source>
        <translation>Aquí llegan los peinados que te pones.</translation>
    </message>
    <message>
        <source>There are no styles in this folder yet.</source>
        <translation>Aún no hay peinados en esta carpeta.</translation>
    </message>
</context>
<context>
    <name>TexelWords</name>
    <message>
        <source>upright</source>
        <translation>de pie</translation>
    </message>
    <message>
        <source>%1°, %2 % flat</source>
        <extracomment>An angle in degrees, and how flat hair lies, in per cent.</extracomment>
        <translation>%1°, %2 % plano</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>Eraser</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Drag to erase; Shift+click for a straight line from the last point</source>
        <translation>Arrastra para borrar; Mayúsculas+clic traza una línea recta desde el último punto</translation>
    </message>
    <message>
        <source>Drag to paint; Shift+click for a straight line from the last point; Ctrl+click picks</source>
        <translation>Arrastra para pintar; Mayúsculas+clic traza una línea recta desde el último punto; Control+clic toma el valor</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Relleno</translation>
    </message>
    <message>
        <source>Click to fill what has a similar value around the pointer</source>
        <translation>Haz clic para rellenar lo que tenga un valor parecido alrededor del puntero</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>Drag from the first value to the second; Shift keeps to steps of 45 degrees</source>
        <translation>Arrastra del primer valor al segundo; Mayúsculas limita el ángulo a pasos de 45 grados</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Picker</source>
        <translation>Cuentagotas</translation>
    </message>
    <message>
        <source>Click to take the value under the pointer</source>
        <translation>Haz clic para tomar el valor bajo el puntero</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Drag a filled shape; Shift makes it a square or a circle; polygons: click corner by corner</source>
        <translation>Arrastra una forma rellena; Mayúsculas la hace cuadrado o círculo; polígonos: haz clic esquina por esquina</translation>
    </message>
    <message>
        <source>Drag a rectangle, Shift adds to the selection or makes a square; click to select nothing</source>
        <translation>Arrastra un rectángulo; Mayúsculas añade a la selección o hace un cuadrado; haz clic para no seleccionar nada</translation>
    </message>
    <message>
        <source>Click corner by corner; click the first one to close; Backspace takes one back</source>
        <translation>Haz clic esquina a esquina; haz clic en la primera para cerrar; Retroceso quita la última</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peine</translation>
    </message>
    <message>
        <source>Drag to lay hair along the stroke; Shift+click for a straight line from the last point</source>
        <translation>Arrastra para tender el pelo a lo largo del trazo; Mayúsculas+clic traza una línea recta desde el último punto</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Raya</translation>
    </message>
    <message>
        <source>Drag the point, or double-click it to keep the part; Delete takes the point away</source>
        <translation>Arrastra el punto, o haz doble clic en él para conservar la raya; Supr quita el punto</translation>
    </message>
    <message>
        <source>Click to go on, drag points or the curve; Enter keeps the part, Esc leaves no trace</source>
        <translation>Haz clic para seguir, arrastra los puntos o la curva; Intro conserva la raya, Esc no deja rastro</translation>
    </message>
    <message>
        <source>Click or drag along the part; hair falls to both sides of it</source>
        <translation>Haz clic o arrastra a lo largo de la raya; el pelo cae a ambos lados</translation>
    </message>
    <message>
        <source>Click where the part goes on; Esc leaves no trace</source>
        <translation>Haz clic donde sigue la raya; Esc no deja rastro</translation>
    </message>
    <message>
        <source>Grab</source>
        <translation>Agarrar</translation>
    </message>
    <message>
        <source>Press on hair and drag it where it should go; with Ctrl it grows or shrinks to the pointer</source>
        <translation>Pulsa en el pelo y arrástralo adonde deba ir; con Ctrl crece o se acorta hasta el puntero</translation>
    </message>
    <message>
        <source>Hold as it lies</source>
        <translation>Fijar como está</translation>
    </message>
    <message>
        <source>Drag over hair to lay it as its neighbours lie</source>
        <translation>Arrastra sobre el pelo para que caiga como el de alrededor</translation>
    </message>
    <message>
        <source>Drag over hair to ruffle it</source>
        <translation>Arrastra sobre el pelo para despeinarlo</translation>
    </message>
    <message>
        <source>Press where hair is to turn in a whorl as large as the ring; drag to move it</source>
        <translation>Pulsa donde el pelo deba girar en un remolino del tamaño del anillo; arrastra para moverlo</translation>
    </message>
    <message>
        <source>Drag over hair to hold it as it lies now, with at least that much gel</source>
        <translation>Arrastra sobre el pelo para fijarlo como está ahora, con al menos ese gel</translation>
    </message>
    <message>
        <source>Drag over hair to lift it, with a Lift below zero to lay it; its direction stays</source>
        <translation>Arrastra sobre el pelo para levantarlo o, con Elevación bajo cero, tumbarlo; su dirección se mantiene</translation>
    </message>
    <message>
        <source>Takes paint off the active layer, so that what lies below shows again.</source>
        <translation>Quita pintura de la capa activa, de modo que vuelve a verse lo que hay debajo.</translation>
    </message>
    <message>
        <source>Paints the chosen value on the active map, on the flat map or on the head.</source>
        <translation>Pinta el valor elegido en el mapa activo, sobre el mapa plano o sobre la cabeza.</translation>
    </message>
    <message>
        <source>Lays, lifts, smooths or swirls hair where it is drawn along.</source>
        <translation>Tiende, levanta, alisa o arremolina el pelo por donde pasa.</translation>
    </message>
    <message>
        <source>Fills a whole patch, or the whole map, with the chosen value.</source>
        <translation>Rellena una mancha entera, o todo el mapa, con el valor elegido.</translation>
    </message>
    <message>
        <source>Takes hold of hair where it is seen and lays it where it is let go.</source>
        <translation>Agarra el pelo donde se ve y lo tiende donde se suelta.</translation>
    </message>
    <message>
        <source>Paints from the first value to the second, along a line or around a point.</source>
        <translation>Pinta del primer valor al segundo, a lo largo de una línea o alrededor de un punto.</translation>
    </message>
    <message>
        <source>Parts the hair along a line.</source>
        <translation>Hace la raya del pelo a lo largo de una línea.</translation>
    </message>
    <message>
        <source>Takes a value from the map, to paint on with it.</source>
        <translation>Toma un valor del mapa para seguir pintando con él.</translation>
    </message>
    <message>
        <source>Limits what is painted to a rectangle.</source>
        <translation>Limita a un rectángulo lo que se pinta.</translation>
    </message>
    <message>
        <source>Paints filled rectangles, ellipses and polygons.</source>
        <translation>Pinta rectángulos, elipses y polígonos rellenos.</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Tijeras</translation>
    </message>
    <message>
        <source>Cuts the hair that a line over the 3D area crosses.</source>
        <translation>Cortan el pelo que cruza una línea trazada sobre el área 3D.</translation>
    </message>
    <message>
        <source>Drag a line over the hair in the 3D area; Shift keeps it level, upright or aslant</source>
        <translation>Traza una línea sobre el pelo en el área 3D; con Mayús queda horizontal, vertical o en diagonal</translation>
    </message>
    <message>
        <source>Draw around hair in the 3D area: what is inside falls; Esc leaves no trace</source>
        <translation>Rodea pelo en el área 3D: lo que queda dentro cae; Esc no deja rastro</translation>
    </message>
    <message>
        <source>Cut hair</source>
        <translation>Cortar pelo</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Dedos</translation>
    </message>
    <message>
        <source>Puffs, pinches, spreads or smooths hair where it is drawn over.</source>
        <translation>Ahuecan, pellizcan, abren o alisan el pelo por donde pasan.</translation>
    </message>
    <message>
        <source>Drag over hair to puff it up; it gets the gel that keeps it</source>
        <translation>Arrastra sobre el pelo para ahuecarlo; recibe el gel que lo mantiene</translation>
    </message>
    <message>
        <source>Drag along hair to pinch it together in a lock; a click gathers it to a point</source>
        <translation>Arrastra a lo largo del pelo para reunirlo en un mechón; un clic lo reúne en un punto</translation>
    </message>
    <message>
        <source>Drag along hair to spread it, away from the middle of the stroke</source>
        <translation>Arrastra a lo largo del pelo para abrirlo, alejándolo del centro del trazo</translation>
    </message>
    <message>
        <source>Drag over hair to make its direction, length, curl and frizz more even</source>
        <translation>Arrastra sobre el pelo para igualar su dirección, largo, rizo y encrespado</translation>
    </message>
    <message>
        <source>Pinch hair</source>
        <translation>Pellizcar el pelo</translation>
    </message>
    <message>
        <source>Spread hair</source>
        <translation>Abrir el pelo</translation>
    </message>
    <message>
        <source>Smooth hair</source>
        <translation>Alisar el pelo</translation>
    </message>
    <message>
        <source>Puff hair</source>
        <translation>Ahuecar el pelo</translation>
    </message>
    <message>
        <source>Point at hair, and drag a node of the hairs that are shown; they keep their length</source>
        <translation>Apunta al pelo y arrastra un nodo de los pelos que se muestran; conservan su largo</translation>
    </message>
    <message>
        <source>Lift hair</source>
        <translation>Levantar el pelo</translation>
    </message>
    <message>
        <source>Comb hair smooth</source>
        <translation>Alisar el pelo con el peine</translation>
    </message>
    <message>
        <source>Ruffle hair</source>
        <translation>Despeinar el pelo</translation>
    </message>
    <message>
        <source>Lay a whorl</source>
        <translation>Trazar un remolino</translation>
    </message>
</context>
<context>
    <name>ToolOptions</name>
    <message>
        <source>Pen pressure changes the size</source>
        <translation>La presión del lápiz cambia el tamaño</translation>
    </message>
    <message>
        <source>Pen pressure changes the opacity</source>
        <translation>La presión del lápiz cambia la opacidad</translation>
    </message>
    <message>
        <source>Comb along the stroke</source>
        <translation>Peinar a lo largo del trazo</translation>
    </message>
    <message>
        <source>Lift or lay, the way hair lies</source>
        <translation>Levantar o tender, según cae el pelo</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Alisar</translation>
    </message>
    <message>
        <source>Ruffle</source>
        <translation>Despeinar</translation>
    </message>
    <message>
        <source>Whorl: a spiral around the pointer</source>
        <translation>Remolino: una espiral alrededor del puntero</translation>
    </message>
    <message>
        <source>Hold as it lies now, with gel</source>
        <translation>Fijar como está ahora, con gel</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Elevación</translation>
    </message>
    <message>
        <source>How far hair is raised from where it lies; below zero it is laid flatter</source>
        <translation>Cuánto se levanta el pelo desde donde está; bajo cero queda más plano</translation>
    </message>
    <message>
        <source>Gel at least</source>
        <translation>Gel mínimo</translation>
    </message>
    <message>
        <source>The gel that keeps held hair as it lies</source>
        <translation>El gel que mantiene el pelo fijado como está</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>The gel that keeps hair where it was pulled; long hair falls back without</source>
        <translation>El gel que mantiene el pelo donde se llevó; sin él, el pelo largo vuelve a caer</translation>
    </message>
    <message>
        <source>Linear gradient</source>
        <translation>Degradado lineal</translation>
    </message>
    <message>
        <source>Radial gradient</source>
        <translation>Degradado radial</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>How far to either side the part lays hair</source>
        <translation>Hasta dónde peina la raya el pelo a cada lado</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Hueco</translation>
    </message>
    <message>
        <source>How wide a line of skin shows; 0 leaves every hair</source>
        <translation>Qué ancho de piel se ve; 0 deja todo el pelo</translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation>Zigzag</translation>
    </message>
    <message>
        <source>How far the part runs to and fro; 0 leaves it straight</source>
        <translation>Cuánto va y viene la raya; 0 la deja recta</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Dureza</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>How flat combed hair lies; pen pressure makes it less</source>
        <translation>Lo plano que queda el pelo peinado; la presión del lápiz lo reduce</translation>
    </message>
    <message>
        <source>Cut along a straight line</source>
        <translation>Cortar por una línea recta</translation>
    </message>
    <message>
        <source>Cut along the line as it is drawn</source>
        <translation>Cortar por la línea tal como se traza</translation>
    </message>
    <message>
        <source>Cut off what is inside</source>
        <translation>Cortar lo que queda dentro</translation>
    </message>
    <message>
        <source>Also behind the head</source>
        <translation>También detrás de la cabeza</translation>
    </message>
    <message>
        <source>Cut what the head hides from here, too</source>
        <translation>Cortar también lo que la cabeza oculta desde aquí</translation>
    </message>
    <message>
        <source>Hairs cut</source>
        <translation>Pelos cortados</translation>
    </message>
    <message>
        <source>Of the hairs that are crossed; fewer thin the ends out</source>
        <translation>De los pelos cruzados; con menos, las puntas se vacían</translation>
    </message>
    <message>
        <source>Ragged</source>
        <translation>Irregular</translation>
    </message>
    <message>
        <source>How far above or below the line each hair is cut</source>
        <translation>Cuánto por encima o por debajo de la línea se corta cada pelo</translation>
    </message>
    <message>
        <source>On what is seen in the 3D area: skin, or hair that hangs over it (T)</source>
        <translation>Sobre lo que se ve en el área 3D: la piel, o el pelo que cuelga sobre ella (T)</translation>
    </message>
    <message>
        <source>On the skin, through the hair (T)</source>
        <translation>Sobre la piel, a través del pelo (T)</translation>
    </message>
    <message>
        <source>On the hair that is seen, whatever lies below (T)</source>
        <translation>Sobre el pelo que se ve, haya lo que haya debajo (T)</translation>
    </message>
    <message>
        <source>Puff: lift hair off the skin</source>
        <translation>Ahuecar: levanta el pelo de la piel</translation>
    </message>
    <message>
        <source>Pinch: gather hair in a lock along the stroke</source>
        <translation>Pellizcar: reúne el pelo en un mechón a lo largo del trazo</translation>
    </message>
    <message>
        <source>Spread: part hairs and locks from each other</source>
        <translation>Abrir: separa pelos y mechones unos de otros</translation>
    </message>
    <message>
        <source>Smooth: even out how hair lies, is long and curls</source>
        <translation>Alisar: iguala la caída, el largo y el rizo del pelo</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>How much a stroke does; pen pressure makes it less, another stroke more</source>
        <translation>Cuánto hace un trazo; la presión del lápiz lo reduce, otro trazo lo aumenta</translation>
    </message>
    <message>
        <source>Grab hair wherever it is seen</source>
        <translation>Agarrar el pelo donde se ve</translation>
    </message>
    <message>
        <source>Bend single hairs by their nodes; the hair around follows</source>
        <translation>Doblar pelos sueltos por sus nodos; el pelo de alrededor los sigue</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>What is painted on the active map</source>
        <translation>Lo que se pinta en el mapa activo</translation>
    </message>
</context>
<context>
    <name>Worn</name>
    <message>
        <source>Add &amp;collider here</source>
        <translation>Añadir &amp;elipsoide de colisión aquí</translation>
    </message>
    <message>
        <source>An ellipsoid where the pointer was last on the head, which hair does not enter; %1 at most</source>
        <translation>Un elipsoide donde estuvo el puntero por última vez sobre la cabeza, en el que el pelo no entra; %1 como máximo</translation>
    </message>
    <message>
        <source>Remove c&amp;ollider</source>
        <translation>Quitar elip&amp;soide de colisión</translation>
    </message>
    <message>
        <source>Add collider</source>
        <translation>Añadir elipsoide de colisión</translation>
    </message>
    <message>
        <source>Remove collider</source>
        <translation>Quitar elipsoide de colisión</translation>
    </message>
    <message>
        <source>Move collider</source>
        <translation>Mover elipsoide de colisión</translation>
    </message>
    <message>
        <source>Size collider</source>
        <translation>Cambiar tamaño del elipsoide de colisión</translation>
    </message>
    <message>
        <source>Pu&amp;t a ball here</source>
        <translation>Po&amp;ner una bola aquí</translation>
    </message>
    <message>
        <source>A bead where the pointer was last on the head, which hair does not enter; %1 at most</source>
        <translation>Una cuenta donde estuvo el puntero por última vez sobre la cabeza, en la que el pelo no entra; %1 como máximo</translation>
    </message>
    <message>
        <source>Take the ball o&amp;ff</source>
        <translation>Q&amp;uitar la bola</translation>
    </message>
    <message>
        <source>Add ball</source>
        <translation>Añadir bola</translation>
    </message>
    <message>
        <source>Remove ball</source>
        <translation>Quitar bola</translation>
    </message>
    <message>
        <source>Move ball</source>
        <translation>Mover bola</translation>
    </message>
    <message>
        <source>Size ball</source>
        <translation>Cambiar tamaño de la bola</translation>
    </message>
    <message>
        <source>Collider</source>
        <translation>Elipsoide de colisión</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bola</translation>
    </message>
    <message>
        <source>Change look of ball</source>
        <translation>Cambiar aspecto de la bola</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elástico</translation>
    </message>
    <message>
        <source>Ribbon</source>
        <translation>Cinta</translation>
    </message>
    <message>
        <source>Cord</source>
        <translation>Cordón</translation>
    </message>
    <message>
        <source>Metal ring</source>
        <translation>Anillo de metal</translation>
    </message>
    <message>
        <source>Ponytail</source>
        <translation>Coleta</translation>
    </message>
    <message>
        <source>Gathers the active group&apos;s hair, inside the selection if there is one, where the pointer was last on the head; %1 at most</source>
        <translation>Recoge el pelo del grupo activo, dentro de la selección si la hay, donde estuvo el puntero por última vez en la cabeza; %1 como máximo</translation>
    </message>
    <message>
        <source>Add ponytail</source>
        <translation>Añadir coleta</translation>
    </message>
    <message>
        <source>Remove ponytail</source>
        <translation>Quitar coleta</translation>
    </message>
    <message>
        <source>Move ponytail</source>
        <translation>Mover coleta</translation>
    </message>
    <message>
        <source>Size ponytail</source>
        <translation>Tamaño de la coleta</translation>
    </message>
    <message>
        <source>Change look of ponytail</source>
        <translation>Cambiar el aspecto de la coleta</translation>
    </message>
    <message>
        <source>Tie radius</source>
        <translation>Radio del coletero</translation>
    </message>
    <message>
        <source>Gather hair into a ponytail</source>
        <translation>Recoger el pelo en una coleta</translation>
    </message>
    <message>
        <source>Bun</source>
        <translation>Moño</translation>
    </message>
    <message>
        <source>Winds the active group&apos;s hair up, inside the selection if there is one, where the pointer was last on the head; %1 at most</source>
        <translation>Enrolla el pelo del grupo activo, dentro de la selección si la hay, donde estuvo el puntero por última vez en la cabeza; %1 como máximo</translation>
    </message>
    <message>
        <source>Add bun</source>
        <translation>Añadir moño</translation>
    </message>
    <message>
        <source>Remove bun</source>
        <translation>Quitar moño</translation>
    </message>
    <message>
        <source>Move bun</source>
        <translation>Mover moño</translation>
    </message>
    <message>
        <source>Size bun</source>
        <translation>Tamaño del moño</translation>
    </message>
    <message>
        <source>Change look of bun</source>
        <translation>Cambiar el aspecto del moño</translation>
    </message>
    <message>
        <source>Wind hair into a bun</source>
        <translation>Enrollar el pelo en un moño</translation>
    </message>
    <message>
        <source>Headband</source>
        <translation>Diadema</translation>
    </message>
    <message>
        <source>&amp;Headband here</source>
        <translation>&amp;Diadema aquí</translation>
    </message>
    <message>
        <source>A band over the head where the pointer was last on it; %1 at most</source>
        <translation>Una banda sobre la cabeza donde estuvo el puntero por última vez; %1 como máximo</translation>
    </message>
    <message>
        <source>Add headband</source>
        <translation>Añadir diadema</translation>
    </message>
    <message>
        <source>Remove headband</source>
        <translation>Quitar diadema</translation>
    </message>
    <message>
        <source>Move headband</source>
        <translation>Mover diadema</translation>
    </message>
    <message>
        <source>Size headband</source>
        <translation>Tamaño de la diadema</translation>
    </message>
    <message>
        <source>Change look of headband</source>
        <translation>Cambiar el aspecto de la diadema</translation>
    </message>
    <message>
        <source>Half width</source>
        <translation>Media anchura</translation>
    </message>
    <message>
        <source>Ribbon bow</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>A bow where the pointer was last on the head; %1 at most</source>
        <translation>Un lazo donde estuvo el puntero por última vez en la cabeza; %1 como máximo</translation>
    </message>
    <message>
        <source>Add ribbon bow</source>
        <translation>Añadir lazo</translation>
    </message>
    <message>
        <source>Remove ribbon bow</source>
        <translation>Quitar lazo</translation>
    </message>
    <message>
        <source>Move ribbon bow</source>
        <translation>Mover lazo</translation>
    </message>
    <message>
        <source>Size ribbon bow</source>
        <translation>Tamaño del lazo</translation>
    </message>
    <message>
        <source>Change look of ribbon bow</source>
        <translation>Cambiar el aspecto del lazo</translation>
    </message>
    <message>
        <source>Hairpin</source>
        <translation>Horquilla</translation>
    </message>
    <message>
        <source>A bent wire where the pointer was last on the head; %1 at most</source>
        <translation>Un alambre doblado donde estuvo el puntero por última vez en la cabeza; %1 como máximo</translation>
    </message>
    <message>
        <source>Add hairpin</source>
        <translation>Añadir horquilla</translation>
    </message>
    <message>
        <source>Remove hairpin</source>
        <translation>Quitar horquilla</translation>
    </message>
    <message>
        <source>Move hairpin</source>
        <translation>Mover horquilla</translation>
    </message>
    <message>
        <source>Size hairpin</source>
        <translation>Tamaño de la horquilla</translation>
    </message>
    <message>
        <source>Change look of hairpin</source>
        <translation>Cambiar el aspecto de la horquilla</translation>
    </message>
    <message>
        <source>Half length</source>
        <translation>Media longitud</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Flor</translation>
    </message>
    <message>
        <source>A blossom where the pointer was last on the head; %1 at most</source>
        <translation>Una flor donde estuvo el puntero por última vez en la cabeza; %1 como máximo</translation>
    </message>
    <message>
        <source>Add flower</source>
        <translation>Añadir flor</translation>
    </message>
    <message>
        <source>Remove flower</source>
        <translation>Quitar flor</translation>
    </message>
    <message>
        <source>Move flower</source>
        <translation>Mover flor</translation>
    </message>
    <message>
        <source>Size flower</source>
        <translation>Tamaño de la flor</translation>
    </message>
    <message>
        <source>Change look of flower</source>
        <translation>Cambiar el aspecto de la flor</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peineta</translation>
    </message>
    <message>
        <source>A comb where the pointer was last on the head; %1 at most</source>
        <translation>Una peineta donde estuvo el puntero por última vez en la cabeza; %1 como máximo</translation>
    </message>
    <message>
        <source>Add comb</source>
        <translation>Añadir peineta</translation>
    </message>
    <message>
        <source>Remove comb</source>
        <translation>Quitar peineta</translation>
    </message>
    <message>
        <source>Move comb</source>
        <translation>Mover peineta</translation>
    </message>
    <message>
        <source>Size comb</source>
        <translation>Tamaño de la peineta</translation>
    </message>
    <message>
        <source>Change look of comb</source>
        <translation>Cambiar el aspecto de la peineta</translation>
    </message>
    <message>
        <source>&amp;Ponytail here</source>
        <translation>&amp;Coleta aquí</translation>
    </message>
    <message>
        <source>Take the tie o&amp;ff</source>
        <translation>Q&amp;uitar el coletero</translation>
    </message>
    <message>
        <source>&amp;Bun here</source>
        <translation>&amp;Moño aquí</translation>
    </message>
    <message>
        <source>Take the bun&apos;s tie o&amp;ff</source>
        <translation>Q&amp;uitar el coletero del moño</translation>
    </message>
    <message>
        <source>Take the headband o&amp;ff</source>
        <translation>Q&amp;uitar la diadema</translation>
    </message>
    <message>
        <source>&amp;Ribbon bow here</source>
        <translation>&amp;Lazo aquí</translation>
    </message>
    <message>
        <source>Take the bow o&amp;ff</source>
        <translation>Q&amp;uitar el lazo</translation>
    </message>
    <message>
        <source>Hairp&amp;in here</source>
        <translation>&amp;Horquilla aquí</translation>
    </message>
    <message>
        <source>Take the hairpin o&amp;ff</source>
        <translation>Q&amp;uitar la horquilla</translation>
    </message>
    <message>
        <source>&amp;Flower here</source>
        <translation>&amp;Flor aquí</translation>
    </message>
    <message>
        <source>Take the flower o&amp;ff</source>
        <translation>Q&amp;uitar la flor</translation>
    </message>
    <message>
        <source>C&amp;omb here</source>
        <translation>&amp;Peineta aquí</translation>
    </message>
    <message>
        <source>Take the comb o&amp;ff</source>
        <translation>Q&amp;uitar la peineta</translation>
    </message>
    <message>
        <source>No hair is left to gather here: paint density, or take another tie off</source>
        <translation>No queda pelo que recoger aquí: pinta densidad o quita otro coletero</translation>
    </message>
    <message>
        <source>Gather hair into twin tails</source>
        <translation>Recoger el pelo en dos coletas</translation>
    </message>
    <message>
        <source>No hair grows on both sides here that two tails could take: paint density on both</source>
        <translation>Aquí no crece pelo a ambos lados para dos coletas: pinte densidad en ambos</translation>
    </message>
    <message>
        <source>Own mesh</source>
        <translation>Malla propia</translation>
    </message>
    <message>
        <source>Own &amp;mesh here…</source>
        <translation>M&amp;alla propia aquí…</translation>
    </message>
    <message>
        <source>A mesh of another program where the pointer was last on the head: a hat, glasses, a tiara; %1 at most</source>
        <translation>Una malla de otro programa donde el puntero estuvo por última vez en la cabeza: un sombrero, gafas, una tiara; %1 como máximo</translation>
    </message>
    <message>
        <source>Take the own mesh o&amp;ff</source>
        <translation>Q&amp;uitar la malla propia</translation>
    </message>
    <message>
        <source>Add own mesh</source>
        <translation>Añadir malla propia</translation>
    </message>
    <message>
        <source>Remove own mesh</source>
        <translation>Quitar malla propia</translation>
    </message>
    <message>
        <source>Move own mesh</source>
        <translation>Mover malla propia</translation>
    </message>
    <message>
        <source>Size own mesh</source>
        <translation>Tamaño de la malla propia</translation>
    </message>
    <message>
        <source>Change look of own mesh</source>
        <translation>Cambiar el aspecto de la malla propia</translation>
    </message>
    <message>
        <source>This tie takes the hair out of the cornrows under it: select the other hair before you put one on</source>
        <translation>Este coletero toma el pelo de las trenzas pegadas que tiene debajo: selecciona antes el resto del pelo</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::AreaMenu</name>
    <message>
        <source>Tie and put on</source>
        <translation>Recoger y poner</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::ClipCommands</name>
    <message>
        <source>Copied from %1</source>
        <translation>Copiado de %1</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Cortar %1</translation>
    </message>
    <message>
        <source>Nothing was copied yet: select a part of a map and copy it first</source>
        <translation>Aún no se ha copiado nada: selecciona una parte de un mapa y cópiala antes</translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation>Borrar %1</translation>
    </message>
    <message>
        <source>Fill %1</source>
        <translation>Rellenar %1</translation>
    </message>
    <message>
        <source>The clipboard holds text, which no map can take; copy a picture or a file</source>
        <translation>El portapapeles contiene texto, que ningún mapa puede recibir; copia una imagen o un archivo</translation>
    </message>
    <message>
        <source>The clipboard holds nothing that a map can take (%1); copy a picture or a file</source>
        <translation>El portapapeles no contiene nada que un mapa pueda recibir (%1); copia una imagen o un archivo</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::EditMenu</name>
    <message>
        <source>&amp;Mirror painting</source>
        <translation>Pintar en e&amp;spejo</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>Pre&amp;ferencias…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Deshacer %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Rehacer %1</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation>D&amp;uplicar capa</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleccionar t&amp;odo</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>No seleccionar &amp;nada</translation>
    </message>
    <message>
        <source>&amp;Invert selection</source>
        <translation>&amp;Invertir selección</translation>
    </message>
    <message>
        <source>Fill &amp;with the value</source>
        <translation>Re&amp;llenar con el valor</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::FileMenu</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>New with a &amp;bald head</source>
        <translation>Nuev&amp;o con la cabeza sin pelo</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>G&amp;uardar como…</translation>
    </message>
    <message>
        <source>Load &amp;image into map…</source>
        <translation>Cargar &amp;imagen en el mapa…</translation>
    </message>
    <message>
        <source>Load &amp;grey image into map…</source>
        <translation>Cargar imagen gris en e&amp;l mapa…</translation>
    </message>
    <message>
        <source>Save &amp;map as image…</source>
        <translation>Guardar el &amp;mapa como imagen…</translation>
    </message>
    <message>
        <source>&amp;Export hair…</source>
        <translation>&amp;Exportar pelo…</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>Guardar cap&amp;tura…</translation>
    </message>
    <message>
        <source>Replace &amp;head</source>
        <translation>Reempla&amp;zar cabeza</translation>
    </message>
    <message>
        <source>&amp;Import head…</source>
        <translation>&amp;Importar cabeza…</translation>
    </message>
    <message>
        <source>&amp;Landmarks…</source>
        <translation>&amp;Puntos de referencia…</translation>
    </message>
    <message>
        <source>Sa&amp;ve maps as images…</source>
        <translation>Guardar mapas &amp;como imágenes…</translation>
    </message>
    <message>
        <source>Edit layer in ano&amp;ther program</source>
        <translation>E&amp;ditar la capa en otro programa</translation>
    </message>
    <message>
        <source>Save &amp;UV sheet…</source>
        <translation>Guardar &amp;hoja UV…</translation>
    </message>
    <message>
        <source>Install B&amp;lender add-on</source>
        <translation>Instalar complemento de &amp;Blender</translation>
    </message>
    <message>
        <source>Import hair &amp;curves…</source>
        <translation>Importar cur&amp;vas de pelo…</translation>
    </message>
    <message>
        <source>Loa&amp;d maps…</source>
        <translation>Cargar ma&amp;pas…</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::FileWork</name>
    <message>
        <source>;;All files (*)</source>
        <translation>;;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Escribiendo %1</translation>
    </message>
    <message>
        <source>%1 written</source>
        <translation>%1 guardado</translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation>Hair Paint</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; was not read: cancelled</source>
        <translation>No se leyó el archivo &apos;%1&apos;: cancelado</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; was not written: cancelled</source>
        <translation>No se escribió el archivo &apos;%1&apos;: cancelado</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::HairExchange</name>
    <message>
        <source>Waiting for the newest hair</source>
        <translation>Esperando el pelo más reciente</translation>
    </message>
    <message>
        <source>There is not enough memory for this hair; take less density or smaller maps.</source>
        <translation>No hay memoria suficiente para este pelo; elige menos densidad o mapas más pequeños.</translation>
    </message>
    <message>
        <source>Export hair</source>
        <translation>Exportar pelo</translation>
    </message>
    <message>
        <source>hair</source>
        <translation>pelo</translation>
    </message>
    <message>
        <source>Making cards</source>
        <translation>Haciendo tarjetas</translation>
    </message>
    <message>
        <source>There is no hair to make cards of; paint some density first.</source>
        <translation>No hay pelo del que hacer tarjetas; pinta primero algo de densidad.</translation>
    </message>
    <message>
        <source>Import hair</source>
        <translation>Importar pelo</translation>
    </message>
    <message>
        <source>Hair curves (%1)</source>
        <translation>Curvas de pelo (%1)</translation>
    </message>
    <message>
        <source>The head was replaced while &apos;%1&apos; was read; import it again.</source>
        <translation>La cabeza se reemplazó mientras se leía «%1»; impórtalo de nuevo.</translation>
    </message>
    <message>
        <source>%1 imported</source>
        <translation>%1 importado</translation>
    </message>
    <message>
        <source>Save Blender add-on</source>
        <translation>Guardar complemento de Blender</translation>
    </message>
    <message>
        <source>Python scripts (*.py)</source>
        <translation>Guiones de Python (*.py)</translation>
    </message>
    <message>
        <source>Installing the add-on</source>
        <translation>Instalando el complemento</translation>
    </message>
    <message>
        <source>Blender add-on</source>
        <translation>Complemento de Blender</translation>
    </message>
    <message>
        <source>The add-on is installed in Blender %1. Turn on “Hair Paint hair” there under Edit &gt; Preferences &gt; Add-ons; then File &gt; Import reads hair that is exported as .hair.</source>
        <translation>El complemento está instalado en Blender %1. Activa allí «Hair Paint hair» en Editar &gt; Preferencias &gt; Complementos; después Archivo &gt; Importar lee el pelo exportado como .hair.</translation>
    </message>
    <message>
        <source>The hair was not exported: cancelled</source>
        <translation>No se exportó el pelo: cancelado</translation>
    </message>
    <message>
        <source>No cards were made: cancelled</source>
        <translation>No se crearon tarjetas: cancelado</translation>
    </message>
    <message>
        <source>The Blender add-on was not installed: cancelled</source>
        <translation>No se instaló el complemento de Blender: cancelado</translation>
    </message>
    <message numerus="yes">
        <source>%1 imported; %Ln strands left out, which are broken</source>
        <translation>
            <numerusform>Se importó %1; se omitió %Ln pelo dañado</numerusform>
            <numerusform>Se importó %1; se omitieron %Ln pelos dañados</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hairpaint::app::HairMenu</name>
    <message>
        <source>&amp;Add hair group…</source>
        <translation>&amp;Añadir grupo de pelo…</translation>
    </message>
    <message>
        <source>Remo&amp;ve hair group</source>
        <translation>&amp;Quitar grupo de pelo</translation>
    </message>
    <message>
        <source>&amp;Save style…</source>
        <translation>&amp;Guardar peinado…</translation>
    </message>
    <message>
        <source>&amp;Light…</source>
        <translation>&amp;Luz…</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>&amp;Reset the simulation</source>
        <translation>&amp;Reiniciar la simulación</translation>
    </message>
    <message>
        <source>S&amp;kin tone</source>
        <translation>T&amp;ono de piel</translation>
    </message>
    <message>
        <source>&amp;Brows and lashes</source>
        <translation>&amp;Cejas y pestañas</translation>
    </message>
    <message>
        <source>&amp;Move the head</source>
        <translation>&amp;Mover la cabeza</translation>
    </message>
    <message>
        <source>&amp;Nod</source>
        <translation>&amp;Asentir</translation>
    </message>
    <message>
        <source>Twice down and up, so that the hair swings</source>
        <translation>Dos veces abajo y arriba, para que el pelo oscile</translation>
    </message>
    <message>
        <source>&amp;Shake</source>
        <translation>&amp;Negar</translation>
    </message>
    <message>
        <source>Twice to both sides, so that the hair swings</source>
        <translation>Dos veces a ambos lados, para que el pelo oscile</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Girar</translation>
    </message>
    <message>
        <source>Slowly to one side and the other, so that the hair swings</source>
        <translation>Despacio a un lado y al otro, para que el pelo oscile</translation>
    </message>
    <message>
        <source>Hol&amp;d as it lies now</source>
        <translation>Fi&amp;jar como está ahora</translation>
    </message>
    <message>
        <source>Paints directions and gel so that the active group&apos;s hair, inside the selection if there is one, stays as it lies now</source>
        <translation>Pinta direcciones y gel para que el pelo del grupo activo, dentro de la selección si la hay, quede como está ahora</translation>
    </message>
    <message>
        <source>&amp;Wind blows</source>
        <translation>Sopla el &amp;viento</translation>
    </message>
    <message>
        <source>W&amp;ind settings…</source>
        <translation>Ajustes del v&amp;iento…</translation>
    </message>
    <message>
        <source>Wind and lig&amp;ht by keys</source>
        <translation>Viento &amp;y luz con teclas</translation>
    </message>
    <message>
        <source>Scal&amp;e the hair…</source>
        <translation>Cam&amp;biar la escala del pelo…</translation>
    </message>
    <message>
        <source>Makes all hair of the active group longer, denser or more widely curled by a percentage; a map&apos;s range alone changes no hair</source>
        <translation>Hace todo el pelo del grupo activo más largo, más denso o de rizo más ancho en un porcentaje; el rango de un mapa por sí solo no cambia el pelo</translation>
    </message>
    <message>
        <source>C&amp;ut</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>The hair is not cut: cancelled</source>
        <translation>El pelo no se corta: cancelado</translation>
    </message>
    <message>
        <source>&amp;Trim…</source>
        <translation>&amp;Recortar…</translation>
    </message>
    <message>
        <source>Makes all hair shorter by as much</source>
        <translation>Acorta todo el pelo lo mismo</translation>
    </message>
    <message>
        <source>To a &amp;level…</source>
        <translation>A un &amp;nivel…</translation>
    </message>
    <message>
        <source>Ends all hair at one height: ears, jaw, chin, shoulders or any other</source>
        <translation>Termina todo el pelo a una altura: orejas, mandíbula, mentón, hombros u otra</translation>
    </message>
    <message>
        <source>La&amp;yers…</source>
        <translation>&amp;Capas…</translation>
    </message>
    <message>
        <source>Cuts hair by its distance from the crown</source>
        <translation>Corta el pelo según su distancia a la coronilla</translation>
    </message>
    <message>
        <source>&amp;Fade…</source>
        <translation>&amp;Degradado…</translation>
    </message>
    <message>
        <source>Cuts hair shorter from the top down to the skin at the sides and the nape</source>
        <translation>Corta el pelo cada vez más corto desde arriba hasta la piel en los lados y la nuca</translation>
    </message>
    <message>
        <source>&amp;Tie and put on</source>
        <translation>Recoger y po&amp;ner</translation>
    </message>
    <message>
        <source>Take o&amp;ff what is chosen</source>
        <translation>Q&amp;uitar lo elegido</translation>
    </message>
    <message>
        <source>Fi&amp;nd a style</source>
        <translation>Bu&amp;scar un peinado</translation>
    </message>
    <message>
        <source>Import st&amp;yles…</source>
        <translation>Importar p&amp;einados…</translation>
    </message>
    <message>
        <source>E&amp;xport my styles…</source>
        <translation>E&amp;xportar mis peinados…</translation>
    </message>
    <message>
        <source>T&amp;win tails here</source>
        <translation>Do&amp;s coletas aquí</translation>
    </message>
    <message>
        <source>Gathers the active group&apos;s hair into two tails, where the pointer was last on the head and on the other side, with a parting between them</source>
        <translation>Recoge el pelo del grupo activo en dos coletas, donde el puntero estuvo por última vez en la cabeza y en el otro lado, con una raya entre ellas</translation>
    </message>
    <message>
        <source>&amp;Copy what is chosen to the other side</source>
        <translation>Re&amp;flejar lo elegido al otro lado</translation>
    </message>
    <message>
        <source>Puts one like it on the other side of the head; what is painted is painted there</source>
        <translation>Pone otro igual al otro lado de la cabeza; lo pintado se pinta allí</translation>
    </message>
    <message>
        <source>Rep&amp;eat between two rows…</source>
        <translation>&amp;Repetir entre dos hileras…</translation>
    </message>
    <message>
        <source>Paints cornrows between the two that were painted last, or the two that reach into the selection</source>
        <translation>Pinta trenzas pegadas entre las dos que se pintaron las últimas, o las dos que llegan a la selección</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::HeadExchange</name>
    <message>
        <source>Import head</source>
        <translation>Importar cabeza</translation>
    </message>
    <message>
        <source>Meshes (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)</source>
        <translation>Mallas (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)</translation>
    </message>
    <message>
        <source>Preparing %1</source>
        <translation>Preparando %1</translation>
    </message>
    <message>
        <source>The head so far has no landmarks; the maps stay as they lie</source>
        <translation>La cabeza anterior no tiene puntos de referencia; los mapas se quedan como están</translation>
    </message>
    <message>
        <source>Carrying the hair over</source>
        <translation>Pasando el pelo</translation>
    </message>
    <message>
        <source>The head was not replaced by &apos;%1&apos;: cancelled</source>
        <translation>No se reemplazó la cabeza por &apos;%1&apos;: cancelado</translation>
    </message>
    <message>
        <source>The head was not replaced: cancelled</source>
        <translation>No se reemplazó la cabeza: cancelado</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::HelpMenu</name>
    <message>
        <source>&amp;Help…</source>
        <translation>A&amp;yuda…</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>&amp;Teclas…</translation>
    </message>
    <message>
        <source>&amp;About Hair Paint</source>
        <translation>&amp;Acerca de Hair Paint</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::Jobs</name>
    <message>
        <source>Hair Paint</source>
        <translation>Hair Paint</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Cancelando…</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::Journal</name>
    <message>
        <source>its disk does not answer; save the project to another disk</source>
        <translation>su disco no responde; guarda el proyecto en otro disco</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>H&amp;air</source>
        <translation>&amp;Pelo</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Deshecho: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Rehecho: %1</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Dibujando la imagen</translation>
    </message>
    <message>
        <source>The unsaved work is kept; the next start offers it again.</source>
        <translation>El trabajo sin guardar se conserva; al volver a abrir el programa se ofrecerá otra vez.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not opened, since &apos;%2&apos; was restored and is not saved; save it, then open &apos;%1&apos; by File &gt; Open recent.</source>
        <translation>«%1» no se abrió, porque se recuperó «%2» y está sin guardar; guárdelo y luego abra «%1» desde Archivo &gt; Abrir reciente.</translation>
    </message>
    <message>
        <source>Unsaved work could not be read: %1</source>
        <translation>No se pudo leer trabajo sin guardar: %1</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::MapExchange</name>
    <message>
        <source>There is no hair group whose maps they could be; add one in the panel Hair.</source>
        <translation>No hay ningún grupo de pelo del que puedan ser los mapas; añade uno en el panel Pelo.</translation>
    </message>
    <message numerus="yes">
        <source>There are already %Ln of these files, &apos;%1&apos; among them. Replace them?</source>
        <translation>
            <numerusform>Ya existe %Ln de estos archivos, «%1». ¿Reemplazarlo?</numerusform>
            <numerusform>Ya existen %Ln de estos archivos, entre ellos «%1». ¿Reemplazarlos?</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing maps</source>
        <translation>Escribiendo mapas</translation>
    </message>
    <message numerus="yes">
        <source>%Ln maps written</source>
        <translation>
            <numerusform>%Ln mapa guardado</numerusform>
            <numerusform>%Ln mapas guardados</numerusform>
        </translation>
    </message>
    <message>
        <source>Save UV sheet</source>
        <translation>Guardar hoja UV</translation>
    </message>
    <message>
        <source>uv-sheet</source>
        <translation>hoja-uv</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf);;SVG drawings (*.svg)</source>
        <translation>Documentos PDF (*.pdf);;Dibujos SVG (*.svg)</translation>
    </message>
    <message>
        <source>There is no hair group whose map it could be; add one in the panel Hair.</source>
        <translation>No hay ningún grupo de pelo cuyo mapa pudiera ser; añade uno en el panel Pelo.</translation>
    </message>
    <message>
        <source>Load image into %1</source>
        <translation>Cargar imagen en %1</translation>
    </message>
    <message>
        <source>Load %1 into %2</source>
        <translation>Cargar %1 en %2</translation>
    </message>
    <message>
        <source>%1 was resampled from %2 × %3 to %4 × %4; Map &gt; Map size changes the map&apos;s</source>
        <translation>%1 se ha remuestreado de %2 × %3 a %4 × %4; Mapa &gt; Tamaño del mapa cambia el del mapa</translation>
    </message>
    <message>
        <source>Save %1 as image</source>
        <translation>Guardar %1 como imagen</translation>
    </message>
    <message>
        <source>Images (*.png *.tif *.exr *.tga)</source>
        <translation>Imágenes (*.png *.tif *.exr *.tga)</translation>
    </message>
    <message>
        <source>The maps were not written: cancelled</source>
        <translation>No se escribieron los mapas: cancelado</translation>
    </message>
    <message>
        <source>Images (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>Load maps</source>
        <translation>Cargar mapas</translation>
    </message>
    <message>
        <source>There is no image in &apos;%1&apos;; choose a folder that holds some.</source>
        <translation>No hay ninguna imagen en «%1»; elige una carpeta que contenga alguna.</translation>
    </message>
    <message>
        <source>the copied image</source>
        <translation>la imagen copiada</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::MapMenu</name>
    <message>
        <source>Map &amp;size</source>
        <translation>&amp;Tamaño del mapa</translation>
    </message>
    <message>
        <source>&amp;Add layer</source>
        <translation>&amp;Añadir capa</translation>
    </message>
    <message>
        <source>&amp;Remove layer</source>
        <translation>&amp;Quitar capa</translation>
    </message>
    <message>
        <source>Layer &amp;up</source>
        <translation>&amp;Subir capa</translation>
    </message>
    <message>
        <source>Layer &amp;down</source>
        <translation>&amp;Bajar capa</translation>
    </message>
    <message>
        <source>%1 × %1</source>
        <translation>%1 × %1</translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation>Hair Paint</translation>
    </message>
    <message>
        <source>The map keeps its size: cancelled</source>
        <translation>El mapa conserva su tamaño: cancelado</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::OpeningSign</name>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Growing the hair of &apos;%1&apos;…</source>
        <translation>Haciendo crecer el pelo de «%1»…</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::OutsideEdit</name>
    <message>
        <source>There is no layer to be edited; add one in the panel Layers.</source>
        <translation>No hay ninguna capa que editar; añade una en el panel Capas.</translation>
    </message>
    <message>
        <source>The layer &apos;%1&apos; is locked; unlock it in the panel Layers first.</source>
        <translation>La capa «%1» está bloqueada; desbloquéala antes en el panel Capas.</translation>
    </message>
    <message>
        <source>The system knows no program that opens &apos;%1&apos;; open it yourself: what is saved there comes back.</source>
        <translation>El sistema no conoce ningún programa que abra «%1»; ábrelo tú: lo que se guarde allí vuelve.</translation>
    </message>
    <message>
        <source>%1 is open elsewhere: what is saved there comes back</source>
        <translation>%1 está abierto en otro programa: lo que se guarde allí vuelve</translation>
    </message>
    <message>
        <source>The layer of &apos;%1&apos; is no longer there; undo what removed it and save the image again.</source>
        <translation>La capa de «%1» ya no existe; deshaz lo que la quitó y guarda la imagen de nuevo.</translation>
    </message>
    <message>
        <source>%1 came back</source>
        <translation>%1 ha vuelto</translation>
    </message>
    <message>
        <source>Edit %1 elsewhere</source>
        <translation>Editar %1 en otro programa</translation>
    </message>
    <message>
        <source>The layer of &apos;%1&apos; is in another project; open that one and load the image into its map with File &gt; Load image into map.</source>
        <translation>La capa de «%1» está en otro proyecto; abre ese y carga la imagen en su mapa con Archivo &gt; Cargar imagen en el mapa.</translation>
    </message>
    <message>
        <source>The layer &apos;%1&apos; is locked; unlock it in the panel Layers and save &apos;%2&apos; again.</source>
        <translation>La capa «%1» está bloqueada; desbloquéala en el panel Capas y guarda «%2» de nuevo.</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::PictureExchange</name>
    <message>
        <source>PNG images (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>OpenEXR images in linear light (*.exr)</source>
        <translation>Imágenes OpenEXR en luz lineal (*.exr)</translation>
    </message>
    <message>
        <source>JPEG images (*.jpg)</source>
        <translation>Imágenes JPEG (*.jpg)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Guardar captura</translation>
    </message>
    <message>
        <source>hairstyle</source>
        <translation>peinado</translation>
    </message>
    <message>
        <source>Saving the picture %1</source>
        <translation>Guardando la imagen %1</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; was not saved: cancelled</source>
        <translation>No se guardó la imagen &apos;%1&apos;: cancelado</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::ProjectFiles</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Hair Paint projects (*.hairpaint)</source>
        <translation>Proyectos de Hair Paint (*.hairpaint)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Guardando %1</translation>
    </message>
    <message>
        <source>Starting a new project</source>
        <translation>Empezando un proyecto nuevo</translation>
    </message>
    <message>
        <source>Restoring unsaved work</source>
        <translation>Recuperando el trabajo sin guardar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no longer where it was; saving writes it again.</source>
        <translation>«%1» ya no está donde estaba; al guardar se escribe de nuevo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was changed by another program; saving asks before it replaces that.</source>
        <translation>Otro programa ha cambiado «%1»; al guardar se pregunta antes de reemplazarlo.</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>Reparando %1</translation>
    </message>
    <message>
        <source>%1 (repaired)</source>
        <translation>%1 (reparado)</translation>
    </message>
    <message>
        <source>No new project was started: cancelled</source>
        <translation>No se empezó un proyecto nuevo: cancelado</translation>
    </message>
    <message>
        <source>The project &apos;%1&apos; was not opened: cancelled</source>
        <translation>No se abrió el proyecto &apos;%1&apos;: cancelado</translation>
    </message>
    <message>
        <source>The unsaved work was not restored: cancelled; the next start offers it again</source>
        <translation>No se recuperó el trabajo sin guardar: cancelado; el próximo inicio lo ofrece de nuevo</translation>
    </message>
    <message>
        <source>The project &apos;%1&apos; was not saved: cancelled</source>
        <translation>No se guardó el proyecto &apos;%1&apos;: cancelado</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::RecoveryDialog</name>
    <message>
        <source>today, %1</source>
        <translation>hoy, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>ayer, %1</translation>
    </message>
    <message>
        <source>Never saved</source>
        <translation>Nunca guardado</translation>
    </message>
    <message numerus="yes">
        <source>Last changed %1, %n step(s) to undo</source>
        <translation>
            <numerusform>Último cambio: %1; %n paso para deshacer</numerusform>
            <numerusform>Último cambio: %1; %n pasos para deshacer</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Trabajo sin guardar</translation>
    </message>
    <message>
        <source>Hair Paint ended before this was saved. Restoring brings it back with its undo steps; the project&apos;s file stays as it is until you save.</source>
        <translation>Hair Paint terminó antes de guardar esto. Al recuperarlo vuelve con sus pasos de deshacer; el archivo del proyecto queda como está hasta que guarde.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Recuperar</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>A&amp;hora no</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>It is offered again at the next start</source>
        <translation>Se vuelve a ofrecer en el próximo inicio</translation>
    </message>
    <message>
        <source>Discard the unsaved work on &apos;%1&apos;? This can&apos;t be undone.</source>
        <translation>¿Descartar el trabajo sin guardar en «%1»? No se puede deshacer.</translation>
    </message>
    <message>
        <source>Nothing can be written to &apos;%1&apos; now, so what lies there can be restored but not removed, and is offered again at the next start. Save what you restore.</source>
        <translation>Ahora no se puede escribir en «%1», así que lo que hay allí se puede recuperar pero no borrar, y se ofrecerá otra vez al volver a abrir el programa. Guarde lo que recupere.</translation>
    </message>
    <message>
        <source>The unsaved work on &apos;%1&apos; can&apos;t be removed: nothing can be written to its folder. It is offered again at the next start.</source>
        <translation>El trabajo sin guardar en «%1» no se puede borrar: no se puede escribir en su carpeta. Se ofrecerá otra vez al volver a abrir el programa.</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::RepairDialog</name>
    <message>
        <source>Repaired project</source>
        <translation>Proyecto reparado</translation>
    </message>
    <message>
        <source>Everything in &apos;%1&apos; could be read. The damaged file stays as it is; save what was read under another name.</source>
        <translation>Se ha podido leer todo lo que hay en «%1». El archivo dañado queda como está; guarda lo leído con otro nombre.</translation>
    </message>
    <message>
        <source>What could be read of &apos;%1&apos; is open. The damaged file stays as it is; save what was read under another name.

This was lost:</source>
        <translation>Está abierto lo que se ha podido leer de «%1». El archivo dañado queda como está; guarda lo leído con otro nombre.

Se ha perdido esto:</translation>
    </message>
    <message>
        <source>What was lost</source>
        <translation>Lo que se ha perdido</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::Session</name>
    <message>
        <source>There is not enough memory for this hair: what is shown is older. Undo the last change, or take less density or smaller maps.</source>
        <translation>No hay memoria suficiente para este pelo: lo que se ve es anterior. Deshaz el último cambio, o elige menos densidad o mapas más pequeños.</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::StyleCards</name>
    <message>
        <source>Drawing the style %1</source>
        <translation>Dibujando el peinado %1</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>sin elegir</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>Pelo</translation>
    </message>
    <message>
        <source>None: a bald head</source>
        <translation>Ninguno: una cabeza calva</translation>
    </message>
    <message>
        <source>Hair type</source>
        <translation>Tipo de pelo</translation>
    </message>
    <message>
        <source>Longest hair</source>
        <translation>Pelo más largo</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>Pelos</translation>
    </message>
    <message>
        <source>%1, led by at most %2 that are computed</source>
        <translation>%1, guiados por %2 calculados como mucho</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coste</translation>
    </message>
    <message>
        <source>A second of its motion takes %1 s here</source>
        <translation>Un segundo de su movimiento tarda aquí %1 s</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Pintado</translation>
    </message>
    <message>
        <source>How it was made</source>
        <translation>Cómo se hizo</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <extracomment>%1: a tool, and on what; %2: how often in a row.</extracomment>
        <translation>%1 × %2</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::StyleFiles</name>
    <message>
        <source>Save style</source>
        <translation>Guardar peinado</translation>
    </message>
    <message>
        <source>Name of the style</source>
        <translation>Nombre del peinado</translation>
    </message>
    <message>
        <source>My style</source>
        <translation>Mi peinado</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; could not be made; check that you may write there.</source>
        <translation>No se pudo crear la carpeta «%1»; comprueba que puedes escribir ahí.</translation>
    </message>
    <message>
        <source>There is a style &apos;%1&apos; already. Replace it?</source>
        <translation>Ya hay un peinado «%1». ¿Quieres reemplazarlo?</translation>
    </message>
    <message>
        <source>Saving style %1</source>
        <translation>Guardando el estilo %1</translation>
    </message>
    <message>
        <source>Style &apos;%1&apos; saved</source>
        <translation>Peinado «%1» guardado</translation>
    </message>
    <message>
        <source>Rename style</source>
        <translation>Cambiar el nombre del estilo</translation>
    </message>
    <message>
        <source>Renaming %1</source>
        <translation>Cambiando el nombre de %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; could not be moved to the trash; delete it by hand.</source>
        <translation>«%1» no se pudo mover a la papelera; elimínalo a mano.</translation>
    </message>
    <message>
        <source>The style &apos;%1&apos; was not saved: cancelled</source>
        <translation>No se guardó el estilo &apos;%1&apos;: cancelado</translation>
    </message>
    <message>
        <source>The style &apos;%1&apos; was not renamed: cancelled</source>
        <translation>No se cambió el nombre del estilo &apos;%1&apos;: cancelado</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Words by which &apos;%1&apos; is found, with commas</source>
        <translation>Palabras con las que se encuentra «%1», separadas por comas</translation>
    </message>
    <message>
        <source>Writing the tags of %1</source>
        <translation>Escribiendo las etiquetas de %1</translation>
    </message>
    <message>
        <source>The tags of &apos;%1&apos; were not changed: cancelled</source>
        <translation>No se cambiaron las etiquetas de «%1»: cancelado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has other tags</source>
        <translation>«%1» tiene otras etiquetas</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is this hair now</source>
        <translation>«%1» es ahora este pelo</translation>
    </message>
    <message>
        <source>Drawing the style %1</source>
        <translation>Dibujando el peinado %1</translation>
    </message>
    <message>
        <source>The picture of &apos;%1&apos; was not changed: cancelled</source>
        <translation>No se cambió la imagen de «%1»: cancelado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has a new picture</source>
        <translation>«%1» tiene una imagen nueva</translation>
    </message>
    <message>
        <source>Export style</source>
        <translation>Exportar peinado</translation>
    </message>
    <message>
        <source>Styles (*.hairpreset)</source>
        <translation>Peinados (*.hairpreset)</translation>
    </message>
    <message>
        <source>Export my styles</source>
        <translation>Exportar mis peinados</translation>
    </message>
    <message>
        <source>Import styles</source>
        <translation>Importar peinados</translation>
    </message>
    <message numerus="yes">
        <source>%Ln styles added to yours</source>
        <translation>
            <numerusform>%Ln peinado añadido a los tuyos</numerusform>
            <numerusform>%Ln peinados añadidos a los tuyos</numerusform>
        </translation>
    </message>
    <message>
        <source>You have these styles already</source>
        <translation>Ya tienes estos peinados</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is in the trash</source>
        <translation>«%1» está en la papelera</translation>
    </message>
    <message>
        <source>&apos;%1&apos; could not be brought back; it is &apos;%2&apos; now.</source>
        <translation>No se pudo recuperar «%1»; ahora es «%2».</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::StylePictures</name>
    <message>
        <source>Drawing the style %1</source>
        <translation>Dibujando el estilo %1</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::StyleStripController</name>
    <message>
        <source>Reading the styles</source>
        <translation>Leyendo los estilos</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::ToolsMenu</name>
    <message>
        <source>S&amp;wap values</source>
        <translation>&amp;Intercambiar valores</translation>
    </message>
    <message>
        <source>&amp;Reset values</source>
        <translation>&amp;Restablecer valores</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>Pincel más &amp;pequeño</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pincel más &amp;grande</translation>
    </message>
    <message>
        <source>Wor&amp;k on hair or skin</source>
        <translation>Tra&amp;bajar en el pelo o la piel</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::ViewMenu</name>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Delante</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>De&amp;trás</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>De&amp;recha</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Izquierda</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Arri&amp;ba</translation>
    </message>
    <message>
        <source>B&amp;elow</source>
        <translation>Desde aba&amp;jo</translation>
    </message>
    <message>
        <source>T&amp;hree-quarter</source>
        <translation>Tres &amp;cuartos</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Mirar &amp;desde</translation>
    </message>
    <message>
        <source>&amp;Both areas</source>
        <translation>&amp;Ambas áreas</translation>
    </message>
    <message>
        <source>&amp;3D area only</source>
        <translation>Solo el área &amp;3D</translation>
    </message>
    <message>
        <source>&amp;Paint area only</source>
        <translation>Solo el área de &amp;pintura</translation>
    </message>
    <message>
        <source>&amp;Swap sides</source>
        <translation>&amp;Intercambiar lados</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;justar</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>&amp;Restablecer vista</translation>
    </message>
    <message>
        <source>&amp;Turn to the brush</source>
        <translation>&amp;Girar hacia el pincel</translation>
    </message>
    <message>
        <source>&amp;Mirror the paint area</source>
        <translation>Reflejar el área de pin&amp;tura</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Malla de alambre</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Tema os&amp;curo</translation>
    </message>
    <message>
        <source>Li&amp;ght theme</source>
        <translation>Tema c&amp;laro</translation>
    </message>
    <message>
        <source>Show &amp;colliders</source>
        <translation>Mostrar &amp;elipsoides de colisión</translation>
    </message>
    <message>
        <source>Show d&amp;irections</source>
        <translation>Mo&amp;strar direcciones</translation>
    </message>
    <message>
        <source>Hair &amp;as cards</source>
        <translation>&amp;Ver el pelo como tarjetas</translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation>&amp;Ocultar paneles</translation>
    </message>
    <message>
        <source>&amp;Next area</source>
        <translation>Hacia el área siguie&amp;nte</translation>
    </message>
    <message>
        <source>Pre&amp;vious area</source>
        <translation>&amp;Hacia el área anterior</translation>
    </message>
    <message>
        <source>Dar&amp;k paper</source>
        <translation>Papel osc&amp;uro</translation>
    </message>
</context>
<context>
    <name>hairpaint::app::WornExchange</name>
    <message>
        <source>Put on a mesh</source>
        <translation>Poner una malla</translation>
    </message>
    <message>
        <source>Meshes (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)</source>
        <translation>Mallas (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::AboutDialog</name>
    <message>
        <source>About Hair Paint</source>
        <translation>Acerca de Hair Paint</translation>
    </message>
    <message>
        <source>The program&apos;s picture</source>
        <translation>La imagen del programa</translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation>Hair Paint</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Versión %1</translation>
    </message>
    <message>
        <source>Paint maps over a head and watch the hair grow.</source>
        <translation>Pinta mapas sobre una cabeza y mira crecer el pelo.</translation>
    </message>
    <message>
        <source>After “Hair Paint” by B. Hernandez and I. Rudomin, 2004. Free software under the MIT licence: use it, change it, pass it on. It comes without any warranty.</source>
        <translation>Basado en «Hair Paint», de B. Hernández e I. Rudomín, 2004. Software libre con licencia MIT: úsalo, cámbialo, compártelo. Se ofrece sin garantía alguna.</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Dibuja %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Runs on %1</source>
        <translation>Funciona en %1</translation>
    </message>
    <message>
        <source>Built with %1</source>
        <translation>Construido con %1</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::BarSlider</name>
    <message>
        <source>%1 is the most that can be set here.</source>
        <translation>%1 es lo máximo que se puede poner aquí.</translation>
    </message>
    <message>
        <source>%1 is the least that can be set here.</source>
        <translation>%1 es lo mínimo que se puede poner aquí.</translation>
    </message>
    <message>
        <source>%1 It stays %2.</source>
        <translation>%1 Se queda en %2.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::BarValue</name>
    <message>
        <source>Ctrl-drag for fine, double-click to type, right-click to reset</source>
        <translation>Control+arrastrar: ajuste fino; doble clic: escribir; clic derecho: restablecer</translation>
    </message>
    <message>
        <source>Ctrl-drag for fine, double-click to type</source>
        <translation>Control+arrastrar: ajuste fino; doble clic: escribir</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::CutDialog</name>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>There is no hair to cut in this group.</source>
        <translation>No hay pelo que cortar en este grupo.</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>Shorter by</source>
        <translation>Más corto en</translation>
    </message>
    <message>
        <source>No shorter than</source>
        <translation>No más corto que</translation>
    </message>
    <message>
        <source>Above the chin</source>
        <translation>Sobre el mentón</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Orejas</translation>
    </message>
    <message>
        <source>Jaw</source>
        <translation>Mandíbula</translation>
    </message>
    <message>
        <source>Chin</source>
        <translation>Mentón</translation>
    </message>
    <message>
        <source>Shoulders</source>
        <translation>Hombros</translation>
    </message>
    <message>
        <source>Length at the top</source>
        <translation>Longitud arriba</translation>
    </message>
    <message>
        <source>Length at the crown</source>
        <translation>Longitud en la coronilla</translation>
    </message>
    <message>
        <source>Length at the hairline</source>
        <translation>Longitud en el contorno</translation>
    </message>
    <message>
        <source>Length at the nape</source>
        <translation>Longitud en la nuca</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Empieza en</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Termina en</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::DirectionBall</name>
    <message>
        <source>Where the light comes from</source>
        <translation>De dónde viene la luz</translation>
    </message>
    <message>
        <source>Where the wind blows to</source>
        <translation>Hacia dónde sopla el viento</translation>
    </message>
    <message>
        <source>Drag to turn; double-click for the other half (front or back); arrows for small steps</source>
        <translation>Arrastra para girar; doble clic pasa a la otra mitad (delante o detrás); las flechas dan pasos pequeños</translation>
    </message>
    <message>
        <source>%1° around, %2° up</source>
        <translation>%1° alrededor, %2° hacia arriba</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::EditTarget</name>
    <message>
        <source>There is no hair group to paint on; add one in the Hair panel.</source>
        <translation>No hay ningún grupo de pelo en el que pintar; añade uno en el panel Pelo.</translation>
    </message>
    <message>
        <source>This map has no layer to paint on; add one in the Layers panel.</source>
        <translation>Este mapa no tiene ninguna capa en la que pintar; añade una en el panel Capas.</translation>
    </message>
    <message>
        <source>“%1” is hidden; show the group to paint on it.</source>
        <translation>«%1» está oculto; muestra el grupo para pintar en él.</translation>
    </message>
    <message>
        <source>“%1” is hidden; show the layer to paint on it.</source>
        <translation>«%1» está oculta; muestra la capa para pintar en ella.</translation>
    </message>
    <message>
        <source>“%1” is locked; unlock the layer to paint on it.</source>
        <translation>«%1» está bloqueada; desbloquea la capa para pintar en ella.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: a map&apos;s name; %2: a sentence that says why nothing can be painted on it.</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ExportHairDialog</name>
    <message>
        <source>Export hair</source>
        <translation>Exportar pelo</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>&amp;Program</source>
        <translation>&amp;Programa</translation>
    </message>
    <message>
        <source>&amp;Shape</source>
        <translation>Fo&amp;rma</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Como está ahora</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Asentado</translation>
    </message>
    <message>
        <source>As combed, before it falls</source>
        <translation>Como está peinado, antes de caer</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>Pelos</translation>
    </message>
    <message>
        <source>An even share of the hairs that are there.</source>
        <translation>Una parte uniforme de los pelos que hay.</translation>
    </message>
    <message>
        <source>There are no hairs to be exported here.</source>
        <translation>Aquí no hay pelos que exportar.</translation>
    </message>
    <message>
        <source>Pre&amp;view</source>
        <translation>&amp;Vista previa</translation>
    </message>
    <message>
        <source>Shows the cards in the 3D area, and writes nothing.</source>
        <translation>Muestra las tarjetas en el área 3D, y no escribe nada.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ExportMapsDialog</name>
    <message>
        <source>Save maps as images</source>
        <translation>Guardar mapas como imágenes</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>&amp;Mapas</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>All of %1</source>
        <translation>Todos los de %1</translation>
    </message>
    <message>
        <source>All of every group</source>
        <translation>Todos los de todos los grupos</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Valores</translation>
    </message>
    <message>
        <source>In the colours of their scales</source>
        <translation>Con los colores de sus escalas</translation>
    </message>
    <message>
        <source>As grey</source>
        <translation>En gris</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>Pro&amp;fundidad</translation>
    </message>
    <message>
        <source>16 bits a channel</source>
        <translation>16 bits por canal</translation>
    </message>
    <message>
        <source>8 bits a channel</source>
        <translation>8 bits por canal</translation>
    </message>
    <message>
        <source>Choose folder…</source>
        <translation>Elegir carpeta…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>UV &amp;tiles</source>
        <translation>M&amp;osaicos UV</translation>
    </message>
    <message>
        <source>Side by side on one image</source>
        <translation>Uno junto a otro en una imagen</translation>
    </message>
    <message>
        <source>An image each: %1</source>
        <translation>Una imagen cada uno: %1</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::GroupSettingsPanel</name>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Braids</source>
        <translation>Trenzas</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>%1 of &quot;%2&quot;</source>
        <translation>%1 de «%2»</translation>
    </message>
    <message>
        <source>What was painted on %1 beyond %2 is %2 now; undo brings it back.</source>
        <translation>Lo pintado en %1 por encima de %2 es ahora %2; deshacer lo devuelve.</translation>
    </message>
    <message>
        <source>What was painted on %1 below %2 is %2 now; undo brings it back.</source>
        <translation>Lo pintado en %1 por debajo de %2 es ahora %2; deshacer lo devuelve.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variación</translation>
    </message>
    <message>
        <source>Curl</source>
        <translation>Rizo</translation>
    </message>
    <message>
        <source>Locks</source>
        <translation>Mechones</translation>
    </message>
    <message>
        <source>Hair type</source>
        <translation>Tipo de cabello</translation>
    </message>
    <message>
        <source>From straight (1) by wavy (2) and curly (3) to coily (4): sets the numbers below</source>
        <translation>De liso (1), ondulado (2) y rizado (3) a muy rizado (4): fija los valores de abajo</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Propio</translation>
    </message>
    <message>
        <source>Hair type of &quot;%1&quot;</source>
        <translation>Tipo de cabello de «%1»</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HairImportDialog</name>
    <message>
        <source>Import hair</source>
        <translation>Importar pelo</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>One &amp;unit is</source>
        <translation>Una &amp;unidad es</translation>
    </message>
    <message>
        <source>&amp;Up is</source>
        <translation>Hacia &amp;arriba es</translation>
    </message>
    <message>
        <source>The hair becomes a new group, with maps to paint on.</source>
        <translation>El pelo pasa a ser un grupo nuevo, con mapas en los que pintar.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln strands. In this unit and axis most roots are %1 cm off the skin or further, so they can&apos;t come in: choose another, or Automatic, or export them as they stand on a head.</source>
        <translation>
            <numerusform>%Ln pelo. Con esta unidad y este eje la raíz está a %1 cm de la piel o más, así que no puede entrar: elige otros, o Automático, o expórtalo como está en una cabeza.</numerusform>
            <numerusform>%Ln pelos. Con esta unidad y este eje la mayoría de las raíces está a %1 cm de la piel o más, así que no pueden entrar: elige otros, o Automático, o expórtalos como están en una cabeza.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln strands, turned, scaled and moved until their roots lay on the head.</source>
        <translation>
            <numerusform>%Ln pelo, girado, escalado y movido hasta que su raíz quedó en la cabeza.</numerusform>
            <numerusform>%Ln pelos, girados, escalados y movidos hasta que sus raíces quedaron en la cabeza.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln strands, their roots on the head. Unit: %1; up: %2.</source>
        <translation>
            <numerusform>%Ln pelo, con la raíz en la cabeza. Unidad: %1; arriba: %2.</numerusform>
            <numerusform>%Ln pelos, con las raíces en la cabeza. Unidad: %1; arriba: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HairOnHead</name>
    <message>
        <source>The hair on the head, from the front and from its left</source>
        <translation>El pelo en la cabeza, de frente y desde su izquierda</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HairPanel</name>
    <message>
        <source>Hair</source>
        <translation>Pelo</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Hair groups</source>
        <translation>Grupos de pelo</translation>
    </message>
    <message>
        <source>Remove hair group (Delete)</source>
        <translation>Quitar grupo de pelo (Suprimir)</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1, oculto</translation>
    </message>
    <message>
        <source>Add hair group: choose what grows</source>
        <translation>Añadir grupo de pelo: elige qué crece</translation>
    </message>
    <message>
        <source>What grows?</source>
        <translation>¿Qué crece?</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HandlePanel</name>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>Handles of this haircut</source>
        <translation>Ajustes de este corte</translation>
    </message>
    <message>
        <source>This group has no hair yet: a style gives it some.</source>
        <translation>Este grupo aún no tiene pelo: un peinado se lo da.</translation>
    </message>
    <message>
        <source>As combed</source>
        <translation>Como está peinada</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>En medio</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HeadImportDialog</name>
    <message>
        <source>“%1” holds no triangles. Export the head as a mesh and try again.</source>
        <translation>«%1» no contiene triángulos. Exporta la cabeza como malla e inténtalo de nuevo.</translation>
    </message>
    <message>
        <source>“%1” has no UV layout, and without one there is nothing to paint on. Unwrap the head in your 3D program and export it with its UVs.</source>
        <translation>«%1» no tiene despliegue UV, y sin él no hay dónde pintar. Despliega la cabeza en tu programa 3D y expórtala con sus UV.</translation>
    </message>
    <message>
        <source>Import head</source>
        <translation>Importar cabeza</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>By height</source>
        <translation>Por altura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>One &amp;unit is</source>
        <translation>Una &amp;unidad es</translation>
    </message>
    <message>
        <source>&amp;Up is</source>
        <translation>Hacia &amp;arriba es</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles. %1 cm is no usual height for a head, a bust or a body: check the unit and the axis.</source>
        <translation>
            <numerusform>%Ln triángulo. %1 cm no es una altura normal para una cabeza, un busto o un cuerpo: revisa la unidad y el eje.</numerusform>
            <numerusform>%Ln triángulos. %1 cm no es una altura normal para una cabeza, un busto o un cuerpo: revisa la unidad y el eje.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles, %1 cm tall.</source>
        <translation>
            <numerusform>%Ln triángulo, %1 cm de alto.</numerusform>
            <numerusform>%Ln triángulos, %1 cm de alto.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Carry the hairstyle over</source>
        <translation>&amp;Conservar el peinado</translation>
    </message>
    <message>
        <source>Hairline, parting and every painted map go to the same places of the new head. Otherwise the maps stay as they are, for a head with the same layout.</source>
        <translation>El nacimiento del pelo, la raya y todos los mapas pintados pasan a los mismos lugares de la cabeza nueva. Si no, los mapas se quedan como están, para una cabeza con el mismo despliegue.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangles, %1 cm tall; unit and axis are those that the file tells.</source>
        <translation>
            <numerusform>%Ln triángulo, %1 cm de alto; la unidad y el eje son los que dice el archivo.</numerusform>
            <numerusform>%Ln triángulos, %1 cm de alto; la unidad y el eje son los que dice el archivo.</numerusform>
        </translation>
    </message>
    <message>
        <source>To the front</source>
        <translation>Hacia delante</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>Hacia la izquierda</translation>
    </message>
    <message>
        <source>To the back</source>
        <translation>Hacia atrás</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Hacia la derecha</translation>
    </message>
    <message>
        <source>The &amp;face looks</source>
        <translation>La &amp;cara mira</translation>
    </message>
    <message>
        <source>&amp;Make a layout of our own</source>
        <translation>Hacer un &amp;despliegue propio</translation>
    </message>
    <message>
        <source>Another UV layout, in which no two places of the skin share a texel. For heads without a layout, or whose left and right half lie over each other in it.</source>
        <translation>Otro despliegue UV, en el que no hay dos lugares de la piel que compartan un téxel. Para cabezas sin despliegue, o cuyas mitades izquierda y derecha se solapan en él.</translation>
    </message>
    <message>
        <source>Parts of the character</source>
        <translation>Partes del personaje</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Comes in</source>
        <translation>Entra</translation>
    </message>
    <message>
        <source>Hair grows</source>
        <translation>Crece pelo</translation>
    </message>
    <message>
        <source>It has no UV coordinates.</source>
        <translation>No tiene coordenadas UV.</translation>
    </message>
    <message>
        <source>Tick a part that hair is to grow on; one without UV coordinates needs a layout of our own.</source>
        <translation>Marca una parte en la que crezca pelo; una sin coordenadas UV necesita un despliegue propio.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HeadOverlay</name>
    <message>
        <source>on the far side</source>
        <translation>en el otro lado</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HelpDialog</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Tools work in both areas, on the flat map and straight on the head; scissors cut hair that is seen. What a tool paints goes to the active layer of the active map, inside the selection where there is one.</source>
        <translation>Las herramientas funcionan en las dos áreas, en el mapa plano y directamente en la cabeza; las tijeras cortan el pelo que se ve. Lo que una herramienta pinta va a la capa activa del mapa activo, dentro de la selección si la hay.</translation>
    </message>
    <message>
        <source>Make the brush smaller or larger</source>
        <translation>Achicar o agrandar el pincel</translation>
    </message>
    <message>
        <source>Size sideways, hardness up and down</source>
        <translation>Tamaño a los lados, dureza arriba y abajo</translation>
    </message>
    <message>
        <source>Ctrl and right-drag</source>
        <translation>Control y arrastrar con el botón derecho</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Hold O and drag</source>
        <translation>Mantener O y arrastrar</translation>
    </message>
    <message>
        <source>Straight line from the last point</source>
        <translation>Línea recta desde el último punto</translation>
    </message>
    <message>
        <source>Shift and click</source>
        <translation>Mayúsculas y clic</translation>
    </message>
    <message>
        <source>Pick the value under the pointer</source>
        <translation>Tomar el valor bajo el puntero</translation>
    </message>
    <message>
        <source>Ctrl and click</source>
        <translation>Control y clic</translation>
    </message>
    <message>
        <source>Cancel the stroke</source>
        <translation>Cancelar el trazo</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Move the map; rotate it</source>
        <translation>Desplazar el mapa; girarlo</translation>
    </message>
    <message>
        <source>Space and drag; Shift, Space and drag</source>
        <translation>Espacio y arrastrar; Mayúsculas, Espacio y arrastrar</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Ampliar en el puntero</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>3D area: turn the view</source>
        <translation>Área 3D: girar la vista</translation>
    </message>
    <message>
        <source>Drag the background, or right-drag</source>
        <translation>Arrastrar el fondo, o con el botón derecho</translation>
    </message>
    <message>
        <source>3D area: move the view</source>
        <translation>Área 3D: mover la vista</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Arrastrar con el botón central</translation>
    </message>
    <message>
        <source>3D area: turn the light</source>
        <translation>Área 3D: girar la luz</translation>
    </message>
    <message>
        <source>Shift and right-drag</source>
        <translation>Mayúsculas y arrastrar con el botón derecho</translation>
    </message>
    <message>
        <source>3D area: turn the head, so that the hair swings</source>
        <translation>Área 3D: girar la cabeza para que el pelo oscile</translation>
    </message>
    <message>
        <source>Hold H and drag</source>
        <translation>Mantener H y arrastrar</translation>
    </message>
    <message>
        <source>Pointer</source>
        <translation>Puntero</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>Direction and speed of the wind; gusts let it come and go, turbulence makes it differ from place to place. The hair shows every change at once, and letting go is one step to undo.</source>
        <translation>Dirección y velocidad del viento; las rachas lo hacen ir y venir, la turbulencia lo hace distinto de un lugar a otro. El pelo muestra cada cambio al momento, y al soltar queda un solo paso que deshacer.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Import head</source>
        <translation>Importar cabeza</translation>
    </message>
    <message>
        <source>A mesh says neither its unit nor which way is up, so both are guessed: the picture shows the head beside its height. Set them right before it becomes the head; it needs uv coordinates, which the maps lie on.</source>
        <translation>Una malla no dice ni su unidad ni qué lado queda arriba, así que ambos se deducen: la imagen muestra la cabeza junto a su altura. Corrígelos antes de que pase a ser la cabeza; necesita coordenadas UV, que es donde van los mapas.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Theme, paper, language and what draws the 3D area; and all keys, each of which can be set anew.</source>
        <translation>Tema, papel, idioma y qué dibuja el área 3D; y todas las teclas, que se pueden cambiar una a una.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>See a map&apos;s colours on the hair</source>
        <translation>Ver los colores de un mapa en el pelo</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>Where the hairstyle is carried over, seven landmarks bring both heads together. They are found by the head&apos;s shape; drag one to where it lies on the left head if it was not found right. File &gt; Replace head &gt; Landmarks shows them again, and hair goes along.</source>
        <translation>Cuando se traslada el peinado, siete puntos de referencia hacen coincidir ambas cabezas. Se encuentran por la forma de la cabeza; si alguno no está bien, arrástrelo hasta donde está en la cabeza de la izquierda. Archivo &gt; Reemplazar cabeza &gt; Puntos de referencia los muestra de nuevo, y el pelo los sigue.</translation>
    </message>
    <message>
        <source>The buttons are whole arrangements to start from. Where the key light stands, how strong it is and its colour; the fill follows the camera, the rim light stands behind the head and shines through the hair&apos;s tips, the surroundings brighten the shadows from all sides. The background is the picture&apos;s own.</source>
        <translation>Los botones son iluminaciones completas de las que partir. Dónde está la luz principal, su fuerza y su color; el relleno sigue a la cámara, la luz de contorno está detrás de la cabeza y atraviesa las puntas del pelo, el entorno aclara las sombras desde todos los lados. El fondo es propio de la imagen.</translation>
    </message>
    <message>
        <source>Export hair</source>
        <translation>Exportar pelo</translation>
    </message>
    <message>
        <source>The format says what the file holds, the program whose unit and axes it is written in. USD has the guides and attributes that Unreal reads; Blender reads the curves of .hair with the add-on that File &gt; Install Blender add-on puts there.</source>
        <translation>El formato dice qué contiene el archivo; el programa, con qué unidad y ejes se escribe. USD lleva las guías y los atributos que lee Unreal; Blender lee las curvas de .hair con el complemento que Archivo &gt; Instalar complemento de Blender pone allí.</translation>
    </message>
    <message>
        <source>Save maps as images</source>
        <translation>Guardar mapas como imágenes</translation>
    </message>
    <message>
        <source>Each map becomes an image named after its group and itself. In the colours of their scales maps look as they do here, and File &gt; Load image reads them; as grey their brightness is the value, which File &gt; Load grey image reads. Colours and directions are the same both ways.</source>
        <translation>Cada mapa se convierte en una imagen con el nombre de su grupo y el suyo. Con los colores de sus escalas los mapas se ven como aquí, y Archivo &gt; Cargar imagen los lee; en gris su brillo es el valor, que lee Archivo &gt; Cargar imagen gris. Los colores y las direcciones son iguales de ambas formas.</translation>
    </message>
    <message>
        <source>Fewer hairs are an even share of all. A tolerance leaves out points that lie so near to the line without them that they are hardly missed.</source>
        <translation>Menos pelos son una parte uniforme de todos. La tolerancia omite puntos que quedan tan cerca de la línea sin ellos que apenas se echan en falta.</translation>
    </message>
    <message>
        <source>Paint the first ten maps</source>
        <translation>Pintar los diez primeros mapas</translation>
    </message>
    <message>
        <source>1 to 9, and 0</source>
        <translation>1 a 9, y 0</translation>
    </message>
    <message>
        <source>Hold Alt and 1 to 9, or 0</source>
        <translation>Mantener Alt y 1 a 9, o 0</translation>
    </message>
    <message>
        <source>Cards are strips of hair with textures, for games and avatars. Preview, or View &gt; Hair as cards, shows them in the 3D area in place of the hair, until that is changed, with the number of their triangles.</source>
        <translation>Las tarjetas son tiras de pelo con texturas, para juegos y avatares. Vista previa, o Ver &gt; Ver el pelo como tarjetas, las muestra en el área 3D en lugar del pelo, hasta que este cambie, con el número de sus triángulos.</translation>
    </message>
    <message>
        <source>File &gt; Import hair curves goes the other way: curves of .hair files and USD text become a new hair group, whose maps are told from the strands. A file that tells no unit is placed as it fits the head.</source>
        <translation>Archivo &gt; Importar curvas de pelo va en sentido contrario: las curvas de archivos .hair y de texto USD pasan a ser un grupo de pelo nuevo, cuyos mapas se deducen de los mechones. Un archivo que no dice su unidad se coloca como encaje en la cabeza.</translation>
    </message>
    <message>
        <source>A head whose file had a whole body&apos;s skeleton goes out with it as a VRM avatar: the hair swings on the head&apos;s bone. Bones are told by their names, as Mixamo, Unreal, Blender, VRoid and others have them; arms that hang are held out to the sides, as VRM wants it.</source>
        <translation>Una cabeza cuyo archivo tenía el esqueleto de un cuerpo entero sale con él como avatar VRM: el pelo se mece sobre el hueso de la cabeza. Los huesos se reconocen por sus nombres, como los tienen Mixamo, Unreal, Blender, VRoid y otros; los brazos que cuelgan se extienden a los lados, como VRM lo pide.</translation>
    </message>
    <message>
        <source>Import hair</source>
        <translation>Importar pelo</translation>
    </message>
    <message>
        <source>Hair of other programs, as .hair or USD, becomes a hair group: density, length, direction, curl, braids and colours are told from its curves and painted into the maps. Unit and axes need to be set only where the hair comes in too large, too small or lying on its side.</source>
        <translation>El pelo de otros programas, en .hair o USD, pasa a ser un grupo de pelo: la densidad, la longitud, la dirección, el rizo, las trenzas y los colores se deducen de sus curvas y se pintan en los mapas. La unidad y los ejes solo hace falta indicarlos si el pelo entra demasiado grande, demasiado pequeño o tumbado.</translation>
    </message>
    <message>
        <source>Within an area of the window; pick</source>
        <translation>Dentro de un área de la ventana; elegir</translation>
    </message>
    <message>
        <source>Tab and arrows; Enter</source>
        <translation>Tab y flechas; Intro</translation>
    </message>
    <message>
        <source>From a panel back to the map</source>
        <translation>De un panel de vuelta al mapa</translation>
    </message>
    <message>
        <source>Scale the hair</source>
        <translation>Escalar el pelo</translation>
    </message>
    <message>
        <source>Makes all hair of the active group longer, denser or more widely curled by a percentage, and shows it at once. The ranges of the maps (Greatest length, Greatest density, Curl radius) are another thing: they say how far a map reaches, and what is painted stays as long, dense and wide as it is. Hair beyond a narrower range is cut to it.</source>
        <translation>Hace todo el pelo del grupo activo más largo, más denso o de rizo más ancho en un porcentaje, y lo muestra al momento. Los rangos de los mapas (Longitud máxima, Densidad máxima, Radio del rizo) son otra cosa: dicen hasta dónde llega un mapa, y lo pintado sigue igual de largo, denso y ancho. El pelo que pasa de un rango más corto se corta a él.</translation>
    </message>
    <message>
        <source>The dialog stays open meanwhile: turn the head to see the cards from all sides, choose otherwise and ask for a preview again.</source>
        <translation>El diálogo sigue abierto entretanto: gira la cabeza para ver las tarjetas por todos lados, elige otra cosa y pide otra vista previa.</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Guardar captura</translation>
    </message>
    <message>
        <source>The small picture shows what will be saved; turn the head in the 3D area while the dialog is open, and it follows. The ending of the file&apos;s name says its kind: PNG, JPEG, or OpenEXR in linear light for compositing. More samples a pixel make finer hair and take longer.</source>
        <translation>La imagen pequeña muestra lo que se guardará; gira la cabeza en el área 3D mientras el diálogo está abierto y ella la sigue. La terminación del nombre del archivo dice su tipo: PNG, JPEG u OpenEXR en luz lineal para composición. Más muestras por píxel dan un pelo más fino y tardan más.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Hair &gt; Cut shortens all hair of the active group, inside the selection if there is one, and shows it at once. Trim takes as much from every hair. Cut to a level ends each hair where it first goes below a height, as it lies now: let it come to rest before. Layers cuts by the distance from the crown, Fade by the height; both leave what is shorter as it is, and where they begin and end is counted from the crown (0 %) down to the nape (100 %).</source>
        <translation>Pelo &gt; Cortar acorta todo el pelo del grupo activo, dentro de la selección si la hay, y lo muestra al momento. Recortar quita lo mismo a cada pelo. Cortar a un nivel termina cada pelo donde baja por primera vez de una altura, tal como cae ahora: antes deje que se aquiete. Capas corta según la distancia a la coronilla, Degradado según la altura; ambos dejan lo más corto como está, y dónde empiezan y terminan se cuenta desde la coronilla (0 %) hasta la nuca (100 %).</translation>
    </message>
    <message>
        <source>Repeat between two rows</source>
        <translation>Repetir entre dos hileras</translation>
    </message>
    <message>
        <source>Each stroke of Cornrow on the braid map is a row, also where it touches another; a stroke that begins on a row goes on with it. Hair &gt; Tie and put on &gt; Repeat between two rows paints more between the two that were painted last, or the two that reach into the selection, evenly over the skin and on the other side of the head too where strokes are mirrored.</source>
        <translation>Cada trazo de trenza pegada en el mapa de trenzas es una hilera, también donde toca a otra; un trazo que empieza en una hilera la continúa. Pelo &gt; Recoger y poner &gt; Repetir entre dos hileras pinta más entre las dos que se pintaron las últimas, o las dos que llegan a la selección, por igual sobre la piel y también al otro lado de la cabeza donde los trazos se reflejan.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HexField</name>
    <message>
        <source>“%1” is no colour; type six digits of 0–9 and A–F, such as %2, or rgb(26, 43, 60).</source>
        <translation>«%1» no es un color; escribe seis cifras de 0–9 y A–F, como %2, o rgb(26, 43, 60).</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ImageReadingDialog</name>
    <message>
        <source>Read the image</source>
        <translation>Leer la imagen</translation>
    </message>
    <message>
        <source>What are the pixels of %1 to the map %2?</source>
        <translation>¿Qué son los píxeles de %1 para el mapa %2?</translation>
    </message>
    <message>
        <source>&amp;Colours of its scale</source>
        <translation>&amp;Colores de su escala</translation>
    </message>
    <message>
        <source>&amp;Brightness is the value</source>
        <translation>El &amp;brillo es el valor</translation>
    </message>
    <message>
        <source>The map as it would be</source>
        <translation>El mapa tal como quedaría</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Cargar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::KeysPage</name>
    <message>
        <source>Search by name or key</source>
        <translation>Buscar por nombre o tecla</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
    <message>
        <source>&amp;New key</source>
        <translation>Tecla &amp;nueva</translation>
    </message>
    <message>
        <source>New key of the chosen action</source>
        <translation>Tecla nueva de la acción elegida</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Asignar</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Gives every action its own key again</source>
        <translation>Devuelve a cada acción su propia tecla</translation>
    </message>
    <message>
        <source>Choose an action, then press its new key.</source>
        <translation>Elige una acción y pulsa su tecla nueva.</translation>
    </message>
    <message>
        <source>“%1” has this key now and will lose it.</source>
        <translation>«%1» tiene ahora esta tecla y la perderá.</translation>
    </message>
    <message>
        <source>Press the new key in the field, then Assign.</source>
        <translation>Pulsa la tecla nueva en el campo y después Asignar.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::LandmarksDialog</name>
    <message>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <source>Hair goes to the same places of the new head. Where a point lies elsewhere than on the left, drag it there.</source>
        <translation>El pelo va a los mismos lugares de la cabeza nueva. Si un punto no está donde en la de la izquierda, arrástrelo hasta allí.</translation>
    </message>
    <message>
        <source>No landmarks were found on this head. Drag each point to where it lies on the left; hair goes to the same places.</source>
        <translation>No se han encontrado puntos de referencia en esta cabeza. Arrastre cada punto a donde está en la de la izquierda; el pelo va a los mismos lugares.</translation>
    </message>
    <message>
        <source>Carry the hair over</source>
        <translation>Trasladar el pelo</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Modo de fusión</translation>
    </message>
    <message>
        <source>How the layer mixes with those below it</source>
        <translation>Cómo se mezcla la capa con las de debajo</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Layers, topmost first</source>
        <translation>Capas, la superior primero</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Añadir capa</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Duplicar capa</translation>
    </message>
    <message>
        <source>Move layer up (Alt+Up)</source>
        <translation>Subir capa (Alt+Arriba)</translation>
    </message>
    <message>
        <source>Move layer down (Alt+Down)</source>
        <translation>Bajar capa (Alt+Abajo)</translation>
    </message>
    <message>
        <source>Remove layer (Delete)</source>
        <translation>Quitar capa (Suprimir)</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Mostrar capa</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ocultar capa</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Bloquear capa</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Desbloquear capa</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Renombrar capa</translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation>Opacidad de la capa</translation>
    </message>
    <message>
        <source>Layer blend mode</source>
        <translation>Modo de fusión de la capa</translation>
    </message>
    <message>
        <source>, hidden</source>
        <translation>, oculta</translation>
    </message>
    <message>
        <source>, locked</source>
        <translation>, bloqueada</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>Copia de %1</translation>
    </message>
    <message>
        <source>Duplicate layer &quot;%1&quot;</source>
        <translation>Duplicar capa «%1»</translation>
    </message>
    <message>
        <source>Move layer up</source>
        <translation>Subir capa</translation>
    </message>
    <message>
        <source>Move layer down</source>
        <translation>Bajar capa</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Quitar capa</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::LightDialog</name>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Comes from, around</source>
        <translation>Viene de, alrededor</translation>
    </message>
    <message>
        <source>Comes from, above</source>
        <translation>Viene de, arriba</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Ambiente</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Color de la luz</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Colour temperature</source>
        <translation>Temperatura de color</translation>
    </message>
    <message>
        <source>Fill, beside the camera</source>
        <translation>Relleno, junto a la cámara</translation>
    </message>
    <message>
        <source>Rim, behind the head</source>
        <translation>Contorno, detrás de la cabeza</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>Entorno</translation>
    </message>
    <message>
        <source>Hair scatters light by</source>
        <translation>El pelo dispersa la luz según</translation>
    </message>
    <message>
        <source>What colours the light of that temperature, as a gel before the lamp does. Click to choose it, right-click for white; R, G and B of the weather keys (F7) raise its parts, with Shift they lower them.</source>
        <translation>Lo que colorea la luz de esa temperatura, como un gel ante la lámpara. Haz clic para elegirlo, clic derecho para blanco; R, G y B de las teclas del clima (F7) suben sus partes, con Mayús las bajan.</translation>
    </message>
    <message>
        <source>R %1  G %2  B %3 %</source>
        <translation>R %1  G %2  B %3 %</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MapLegend</name>
    <message>
        <source>What the colours mean</source>
        <translation>Qué significan los colores</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>De pie</translation>
    </message>
    <message>
        <source>Up the map</source>
        <translation>Hacia arriba en el mapa</translation>
    </message>
    <message>
        <source>Down the map</source>
        <translation>Hacia abajo en el mapa</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>A la izquierda</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>A la derecha</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MapRow</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1: %2 x %2 texels</source>
        <translation>%1: %2 x %2 téxeles</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MapTableDialog</name>
    <message>
        <source>Load maps</source>
        <translation>Cargar mapas</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>No se carga</translation>
    </message>
    <message>
        <source>Map of %1</source>
        <translation>Mapa de %1</translation>
    </message>
    <message>
        <source>Hair group of %1</source>
        <translation>Grupo de pelo de %1</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Cargar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation>Mapas</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MelaninSliders</name>
    <message>
        <source>Melanin</source>
        <translation>Melanina</translation>
    </message>
    <message>
        <source>The pigment of hair that is not dyed: from white to black</source>
        <translation>El pigmento del pelo sin teñir: de blanco a negro</translation>
    </message>
    <message>
        <source>Redness</source>
        <translation>Rojez</translation>
    </message>
    <message>
        <source>How much of the pigment is the red one</source>
        <translation>Qué parte del pigmento es la rojiza</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MeshSilhouette</name>
    <message>
        <source>The mesh from the front, beside a person of 1.75 m</source>
        <translation>La malla de frente, junto a una persona de 1,75 m</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::NumberSpinBox</name>
    <message>
        <source>%1 It stays %2.</source>
        <translation>%1 Se queda en %2.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::OptionBar</name>
    <message>
        <source>Tool options</source>
        <translation>Opciones de la herramienta</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Choose the value from the palette</source>
        <translation>Elige el valor en la paleta</translation>
    </message>
    <message>
        <source>Palette, %1</source>
        <translation>Paleta, %1</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::PictureDialog</name>
    <message>
        <source>Square</source>
        <translation>Cuadrada</translation>
    </message>
    <message>
        <source>Large square</source>
        <translation>Cuadrada grande</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Retrato</translation>
    </message>
    <message>
        <source>1080p</source>
        <translation>1080p</translation>
    </message>
    <message>
        <source>1080p upright</source>
        <translation>1080p vertical</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Guardar captura</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>&amp;Framing</source>
        <translation>&amp;Encuadre</translation>
    </message>
    <message>
        <source>As in the 3D area</source>
        <translation>Como en el área 3D</translation>
    </message>
    <message>
        <source>Head and all hair</source>
        <translation>Cabeza y todo el pelo</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>Whole bust</source>
        <translation>Busto entero</translation>
    </message>
    <message>
        <source>All are seen from where the 3D area looks; turn the view there, also while this is open.</source>
        <translation>Todos se ven desde donde mira el área 3D; gira allí la vista, también mientras esto está abierto.</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Calidad</translation>
    </message>
    <message>
        <source>Quick, 1 sample a pixel</source>
        <translation>Rápida, 1 muestra por píxel</translation>
    </message>
    <message>
        <source>Fine, 4 samples a pixel</source>
        <translation>Fina, 4 muestras por píxel</translation>
    </message>
    <message>
        <source>Finest, 16 samples a pixel</source>
        <translation>La más fina, 16 muestras por píxel</translation>
    </message>
    <message>
        <source>As the 3D area</source>
        <translation>Como el área 3D</translation>
    </message>
    <message>
        <source>%1, %2 × %3</source>
        <translation>%1, %2 × %3</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Tamaño propio</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Tamaño</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Ancho</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>A&amp;lto</translation>
    </message>
    <message>
        <source>&amp;Keep the proportion</source>
        <translation>&amp;Mantener la proporción</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparente</translation>
    </message>
    <message>
        <source>A colour</source>
        <translation>Un color</translation>
    </message>
    <message>
        <source>PNG and OpenEXR keep what is transparent; a JPEG shows the 3D area&apos;s background there.</source>
        <translation>PNG y OpenEXR conservan lo transparente; un JPEG muestra allí el fondo del área 3D.</translation>
    </message>
    <message>
        <source>Colour of the background</source>
        <translation>Color del fondo</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Fondo</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Pictures of more than %1 pixels a side have one sample a pixel.</source>
        <translation>Las imágenes de más de %1 píxeles de lado tienen una muestra por píxel.</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Sin vista previa</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Graphics card (OpenGL)</source>
        <translation>Tarjeta gráfica (OpenGL)</translation>
    </message>
    <message>
        <source>As a picture (software)</source>
        <translation>Como imagen (por software)</translation>
    </message>
    <message>
        <source>White &amp;paper under the maps</source>
        <translation>&amp;Papel blanco bajo los mapas</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>El idioma cambia la próxima vez que abras el programa.</translation>
    </message>
    <message>
        <source>3D &amp;area</source>
        <translation>Á&amp;rea 3D</translation>
    </message>
    <message>
        <source>Automatic takes the graphics card where there is one. A change takes effect at the next start.</source>
        <translation>Automático usa la tarjeta gráfica si la hay. El cambio se aplica la próxima vez que abras el programa.</translation>
    </message>
    <message>
        <source>Maps go from white to their colour instead of from black. Exported images always do.</source>
        <translation>Los mapas van del blanco a su color y no desde el negro. Las imágenes exportadas siempre van así.</translation>
    </message>
    <message>
        <source>Keep &amp;earlier versions</source>
        <translation>Conservar versiones &amp;anteriores</translation>
    </message>
    <message>
        <source>Saving a project leaves the last three beside it, as Name~1, Name~2 and Name~3; 1 is the newest.</source>
        <translation>Al guardar un proyecto quedan a su lado los tres últimos, como Nombre~1, Nombre~2 y Nombre~3; el 1 es el más reciente.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::RepeatRowsDialog</name>
    <message>
        <source>Repeat between two rows</source>
        <translation>Repetir entre dos hileras</translation>
    </message>
    <message>
        <source>Cornrows are painted between the two that were painted last, or the two that reach into the selection.</source>
        <translation>Se pintan trenzas pegadas entre las dos que se pintaron las últimas, o las dos que llegan a la selección.</translation>
    </message>
    <message>
        <source>Rows between</source>
        <translation>Hileras en medio</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ScaleHairDialog</name>
    <message>
        <source>Scale the hair</source>
        <translation>Escalar el pelo</translation>
    </message>
    <message>
        <source>Scale the hair of &quot;%1&quot;</source>
        <translation>Escalar el pelo de «%1»</translation>
    </message>
    <message>
        <source>All hair of “%1” changes by the same share. The maps stay as they are painted; their ranges change.</source>
        <translation>Todo el pelo de «%1» cambia en la misma proporción. Los mapas quedan como están pintados; cambian sus rangos.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escalar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::Section</name>
    <message>
        <source>Open</source>
        <translation>Desplegado</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Plegado</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::Sidebar</name>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>Pelo</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::SoftwarePresenter</name>
    <message>
        <source>Hair Paint itself, without a graphics card</source>
        <translation>El propio Hair Paint, sin tarjeta gráfica</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StatusReadout</name>
    <message>
        <source>Status</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Time of one step of the simulation</source>
        <translation>Duración de un paso de la simulación</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Imágenes por segundo</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln hairs</source>
        <translation>
            <numerusform>%1 de %Ln pelo</numerusform>
            <numerusform>%1 de %Ln pelos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hairs</source>
        <translation>
            <numerusform>%Ln pelo</numerusform>
            <numerusform>%Ln pelos</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer hairs than painted: the project&apos;s limit is reached. A lower greatest density leaves room.</source>
        <translation>Menos pelos de los pintados: se alcanza el límite del proyecto. Baja la densidad máxima para hacer sitio.</translation>
    </message>
    <message>
        <source>Fewer hairs than painted: memory would not hold more. Fewer nodes per hair or a lower greatest density leave room.</source>
        <translation>Menos pelos de los pintados: en la memoria no cabrían más. Baja los nodos por pelo o la densidad máxima para hacer sitio.</translation>
    </message>
    <message>
        <source>%1, limit reached</source>
        <translation>%1, límite alcanzado</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>● Not saved</source>
        <translation>● Sin guardar</translation>
    </message>
    <message>
        <source>✓ Saved</source>
        <translation>✓ Guardado</translation>
    </message>
    <message>
        <source>Changes that no file holds yet; Ctrl+S saves them</source>
        <translation>Cambios que aún no están en ningún archivo; Ctrl+S los guarda</translation>
    </message>
    <message>
        <source>%1. Erasing %2</source>
        <translation>%1. Borrar %2</translation>
    </message>
    <message>
        <source>▲ Not saved, no safety copy</source>
        <translation>▲ Sin guardar y sin copia de seguridad</translation>
    </message>
    <message>
        <source>A crash would lose what is not saved: the program could not keep a copy of it (%1). Save it now and then.</source>
        <translation>Un fallo haría perder lo que no está guardado: el programa no pudo guardar una copia (%1). Guárdalo de vez en cuando.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleBar</name>
    <message>
        <source>Folders of styles</source>
        <translation>Carpetas de peinados</translation>
    </message>
    <message>
        <source>What is taken of a style</source>
        <translation>Qué se toma de un peinado</translation>
    </message>
    <message>
        <source>What pointing at a style shows and clicking takes; the rest of your hair stays</source>
        <translation>Lo que se muestra al señalar un peinado y se toma al hacer clic; el resto de tu pelo se queda</translation>
    </message>
    <message>
        <source>Whole style</source>
        <translation>Peinado entero</translation>
    </message>
    <message>
        <source>Find a style</source>
        <translation>Buscar un peinado</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>How much of a style is taken; below 100% it is mixed with the hair that was there. Ties and braids, which can&apos;t be mixed, come with 50% and more</source>
        <translation>Cuánto se toma de un peinado; por debajo del 100 % se mezcla con el pelo que había. Los adornos y las trenzas, que no se pueden mezclar, vienen a partir del 50 %</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleCard</name>
    <message>
        <source>About &apos;%1&apos;</source>
        <translation>Acerca de «%1»</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Dibujando…</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>How much of the card is there</source>
        <translation>Cuánto hay ya de la ficha</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Make it on my head</source>
        <translation>Ponerlo en mi cabeza</translation>
    </message>
    <message>
        <source>Landmarks of my head…</source>
        <translation>Puntos de referencia de mi cabeza…</translation>
    </message>
    <message>
        <source>Hairline, crown, ears: by them the style is laid on your head</source>
        <translation>Nacimiento del pelo, coronilla, orejas: con ellos el peinado se ajusta a tu cabeza</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleFitting</name>
    <message>
        <source>&apos;%1&apos; has no part for the hair of this head; click it to put all of it on.</source>
        <translation>«%1» no tiene nada para el pelo de esta cabeza; haz clic en él para aplicarlo entero.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleMenu</name>
    <message>
        <source>Shift+click</source>
        <translation>Mayús+clic</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorito</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleNotice</name>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleQuestion</name>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Conservar el mío</translation>
    </message>
    <message>
        <source>&amp;Replace mine</source>
        <translation>&amp;Reemplazar el mío</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Esc. The rest of the style is put on</source>
        <translation>Esc. Se aplica el resto del peinado</translation>
    </message>
    <message>
        <source>The style&apos;s own takes its place; undo brings it back</source>
        <translation>El del peinado ocupa su lugar; al deshacer vuelve el tuyo</translation>
    </message>
    <message>
        <source>All hair stays as it was</source>
        <translation>Todo el pelo queda como estaba</translation>
    </message>
    <message>
        <source>&apos;%1&apos; brings its own %2. Replace yours?</source>
        <translation>«%1» trae su propio grupo (%2). ¿Reemplazar el tuyo?</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleRow</name>
    <message>
        <source>Styles</source>
        <translation>Peinados</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleShelf</name>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleStrip</name>
    <message>
        <source>Styles</source>
        <translation>Peinados</translation>
    </message>
    <message>
        <source>Save style</source>
        <translation>Guardar peinado</translation>
    </message>
    <message>
        <source>Save this hair as a style of your own</source>
        <translation>Guarda este pelo como un peinado tuyo</translation>
    </message>
    <message>
        <source>%1. Point to see it, click to keep it; Shift+click takes its colour alone</source>
        <translation>%1. Señálalo para verlo, haz clic para aplicarlo; con Mayús+clic tomas solo su color</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleTile</name>
    <message>
        <source>Loading…</source>
        <translation>Cargando…</translation>
    </message>
    <message>
        <source>Parts of %1</source>
        <translation>Partes de %1</translation>
    </message>
    <message>
        <source>Take a part of this style, and more</source>
        <translation>Tomar una parte de este peinado y más</translation>
    </message>
    <message>
        <source>No favourite any more (%1)</source>
        <translation>Quitar de favoritos (%1)</translation>
    </message>
    <message>
        <source>About this style (Space)</source>
        <translation>Acerca de este estilo (Espacio)</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Acerca de %1</translation>
    </message>
    <message>
        <source>A favourite (%1)</source>
        <translation>Añadir a favoritos (%1)</translation>
    </message>
    <message>
        <source>%1 is a favourite</source>
        <translation>%1 es un favorito</translation>
    </message>
    <message>
        <source>Make %1 a favourite</source>
        <translation>Añadir %1 a favoritos</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorito</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ToolBox</name>
    <message>
        <source>%1 is painted with %2 now: this group&apos;s range ends there.</source>
        <translation>%1 se pinta ahora con %2: el rango de este grupo termina ahí.</translation>
    </message>
    <message>
        <source>%1: draw over the hair in the 3D area.</source>
        <translation>%1: traza sobre el pelo en el área 3D.</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::TurnHint</name>
    <message>
        <source>Drag beside the head to turn it; the wheel zooms</source>
        <translation>Arrastra junto a la cabeza para girarla; la rueda acerca</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ValuePair</name>
    <message>
        <source>Value and second value</source>
        <translation>Valor y segundo valor</translation>
    </message>
    <message>
        <source>Paints %1; the second value is %2. Click a square to choose, the arrow to swap (X)</source>
        <translation>Pinta %1; el segundo valor es %2. Haz clic en un cuadro para elegir y en la flecha para intercambiar (X)</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ValuePalette</name>
    <message>
        <source>Swap the two values (X)</source>
        <translation>Intercambiar los dos valores (X)</translation>
    </message>
    <message>
        <source>Reset the two values (D)</source>
        <translation>Restablecer los dos valores (D)</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>&amp;Hex</source>
        <translation>&amp;Hex</translation>
    </message>
    <message>
        <source>Custom…</source>
        <translation>Otro…</translation>
    </message>
    <message>
        <source>Hair colour</source>
        <translation>Color del pelo</translation>
    </message>
    <message>
        <source>%1, second value</source>
        <translation>%1, segundo valor</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>De pie</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ViewSigns</name>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Refining…</source>
        <translation>Afinando…</translation>
    </message>
    <message>
        <source>Cards: %L1 triangles</source>
        <translation>Tarjetas: %L1 triángulos</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::WeatherOverlay</name>
    <message>
        <source>Weather</source>
        <translation>Clima</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>turn the wind</source>
        <translation>giran el viento</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Re Pág, Av Pág</translation>
    </message>
    <message>
        <source>wind %1 m/s</source>
        <translation>viento a %1 m/s</translation>
    </message>
    <message>
        <source>wind is off</source>
        <translation>sin viento</translation>
    </message>
    <message>
        <source>R  G  B</source>
        <translation>R  G  B</translation>
    </message>
    <message>
        <source>more red, green, blue light</source>
        <translation>más luz roja, verde, azul</translation>
    </message>
    <message>
        <source>Shift+R  G  B</source>
        <translation>Mayúsculas+R  G  B</translation>
    </message>
    <message>
        <source>less</source>
        <translation>menos</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>leaves</source>
        <translation>sale</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::WindDialog</name>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>Wind &amp;blows</source>
        <translation>El viento &amp;sopla</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Blows to, around</source>
        <translation>Sopla hacia, alrededor</translation>
    </message>
    <message>
        <source>0° blows toward the viewer in front, 90° to the right</source>
        <translation>0° sopla hacia quien mira de frente, 90° hacia la derecha</translation>
    </message>
    <message>
        <source>Blows to, upward</source>
        <translation>Sopla hacia, arriba</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rachas</translation>
    </message>
    <message>
        <source>Share of the strength that comes and goes over seconds</source>
        <translation>Parte de la fuerza que va y viene en unos segundos</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulencia</translation>
    </message>
    <message>
        <source>Share of the strength that differs from place to place</source>
        <translation>Parte de la fuerza que cambia de un lugar a otro</translation>
    </message>
</context>
<context>
    <name>hairpaint::view::WornPanel</name>
    <message>
        <source>Worn</source>
        <translation>Accesorios</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Colour of what is worn</source>
        <translation>Color del accesorio</translation>
    </message>
    <message>
        <source>Sheen</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>How much light it reflects without taking its colour: 0 % is matt, 100 % polished</source>
        <translation>Cuánta luz refleja sin tomar su color: 0 % es mate, 100 % pulido</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>What it is made of</source>
        <translation>De qué está hecho</translation>
    </message>
    <message>
        <source>Tightness</source>
        <translation>Tirantez</translation>
    </message>
    <message>
        <source>How taut hair lies on the head before the tie: at 0 % as loose as a coat, at 100 % on the skin</source>
        <translation>Cuán tirante queda el pelo en la cabeza antes del coletero: al 0 % suelto como una capa, al 100 % sobre la piel</translation>
    </message>
    <message>
        <source>Bun radius</source>
        <translation>Radio del moño</translation>
    </message>
    <message>
        <source>How far hair is wound about the tie</source>
        <translation>Hasta dónde se enrolla el pelo alrededor del coletero</translation>
    </message>
    <message>
        <source>Hair goes through it</source>
        <translation>El pelo lo atraviesa</translation>
    </message>
    <message>
        <source>Else hair keeps out of the ellipsoid in its box</source>
        <translation>Si no, el pelo no entra en el elipsoide de su caja</translation>
    </message>
</context>
</TS>
